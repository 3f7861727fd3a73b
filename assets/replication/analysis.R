# SPDX-License-Identifier: GPL-3.0-or-later
#
# Recomputes the numbers of the report from the single marks, in plain R (no packages).
#
#   Rscript analysis.R        in the folder with the tables; R 4.0 or later
#
# Input:   marks.csv             marks of the trainees
#          evaluation_marks.csv  marks of the models
#          measures.csv          measurements of each recorded run
#          given.csv             facts that are not computed: weights, plan, people, record
#          expected.csv          the numbers of the report; read only for the comparison at the end
# Output:  recomputed.csv        every recomputed number beside that of the report
#
# Exit status 0: every recomputed number agrees and none is lacking; 1 otherwise.
# A number agrees if it differs by at most 1e-9, or by 1e-9 of itself if it is greater than 1.

options(digits = 15, stringsAsFactors = FALSE, warn = 1)
tolerance <- 1e-9
confidence <- 0.95
upper_tail <- 1 - (1 - confidence) / 2   # 0.975

# ---- Input ---------------------------------------------------------------------------------------------

read_table <- function(file) {
  table <- read.csv(file, colClasses = "character", na.strings = character(0), check.names = FALSE)
  names(table) <- gsub("[^a-z_]", "", names(table), useBytes = TRUE)   # a byte order mark
  table
}
marks <- read_table("marks.csv")
evaluation <- read_table("evaluation_marks.csv")
measures <- read_table("measures.csv")
given <- read_table("given.csv")
marks$mark <- as.numeric(marks$mark)
evaluation$mark <- as.numeric(evaluation$mark)

in_order <- function(x) sort(unique(x), method = "radix")   # the same order in every locale
facts <- function(section, statistic) given[given$section == section & given$statistic == statistic, ]
# An end of the scale of the training marks, in points: "scale_lowest" or "scale_highest".
scale_of_marks <- function(statistic) {
  rows <- facts("record", statistic)
  as.numeric(rows$value[rows$item == "training_marks"])
}

# ---- Results -------------------------------------------------------------------------------------------

# Every result has a key of seven cells. put() adds one result, or several at once if a cell is a vector.
results <- list()
put <- function(section, statistic, value, item = "all", group = "", model = "", index = "",
                occasion = "") {
  if (length(value) == 0) return(invisible())
  text <- if (is.numeric(value)) ifelse(is.na(value), "", sprintf("%.17g", value)) else as.character(value)
  results[[length(results) + 1]] <<- data.frame(section, item, group, model, index, occasion, statistic,
                                                value = text)
}
put_interval <- function(section, statistic, lower, upper, level = "_95", ...) {
  put(section, paste0(statistic, "_lower", level), lower, ...)
  put(section, paste0(statistic, "_upper", level), upper, ...)
}

# Numbers of the report that this script does not recompute, with the reason.
left_out <- data.frame(section = character(0), statistic = character(0), reason = character(0))
leave_out <- function(section, statistics, reason) {
  left_out <<- rbind(left_out, data.frame(section, statistic = statistics, reason))
}

# ---- Tools ---------------------------------------------------------------------------------------------

# Scores are quotients of whole numbers; rounding makes equal scores equal again before ranks are taken.
for_ranks <- function(x) round(x, 9)

mean_interval <- function(x) {   # Student's t
  n <- length(x)
  mean(x) + c(-1, 1) * qt(upper_tail, n - 1) * sd(x) / sqrt(n)
}

# Holm (1979), and intervals that agree with his p values: each interval is Bonferroni's for the factor by
# which Holm multiplies its p value.
holm <- function(difference, error, df, p) {
  by_size <- order(p)
  steps <- rev(seq_along(p))
  largest <- cummax(steps * p[by_size])
  factor <- numeric(length(p))
  factor[by_size] <- ifelse(p[by_size] > 0, pmax(steps, largest / p[by_size]), steps)
  reach <- qt(1 - (1 - confidence) / 2 / factor, df) * error
  list(p = p.adjust(p, "holm"), lower = difference - reach, upper = difference + reach)
}

pairs_of <- function(n) if (n < 2) matrix(0L, 0, 2) else t(combn(n, 2))

# ---- Evaluation of models: Eqs. 25 to 27 ---------------------------------------------------------------

index_weights <- facts("evaluation", "index_weight")
class_weights <- facts("evaluation", "class_weight")
indices <- index_weights$index
classes <- class_weights$group
models <- unique(evaluation$model)
v <- as.numeric(index_weights$value)
w <- as.numeric(class_weights$value)

put_evaluation <- function(...) put("evaluation", ...)

# Weighted mean of the class means (Eq. 25) with its standard error; degrees of freedom by Welch and
# Satterthwaite. `x` is a list with the marks of each class.
weighted_mean <- function(x) {
  used <- w > 0 & lengths(x) > 0
  share <- w[used] / sum(w[used])
  x <- x[used]
  n <- lengths(x)
  part <- share^2 * sapply(x, var) / n
  list(mean = sum(share * sapply(x, mean)), se = sqrt(sum(part)), df = sum(part)^2 / sum(part^2 / (n - 1)),
       square = sum(share * sapply(x, function(one) mean(one^2))))
}

# Scores exist once every class with a weight has a mark for every index of every model.
marked <- evaluation[!is.na(evaluation$mark) & evaluation$class %in% classes[w > 0], ]
finished <- length(models) > 0 &&
  nrow(unique(marked[c("class", "model", "index")])) == sum(w > 0) * length(models) * length(indices)

composites <- list()
if (finished) {
  all_used_marks <- 0
  for (model in models) {
    of_model <- evaluation[evaluation$model == model & !is.na(evaluation$mark), ]
    m_of_index <- numeric(0)
    used_marks <- 0
    for (index in indices) {
      of_index <- of_model[of_model$index == index, ]
      x <- split(of_index$mark, factor(of_index$class, levels = classes))
      all <- of_index$mark[of_index$class %in% classes[w > 0]]
      n <- length(all)
      m <- weighted_mean(x)
      at <- function(statistic, value) put_evaluation(statistic, value, model = model, index = index)
      at("M", m$mean)
      at("s2_eq26_divisor_n", mean((all - m$mean)^2))
      at("min", min(all))
      at("max", max(all))
      at("plain_mean", mean(all))
      at("population_variance", mean((all - mean(all))^2))
      at("sample_variance", var(all))
      at("class_weighted_moment", m$square - m$mean^2)
      at("se_of_M", m$se)
      at("se_df", m$df)
      used_marks <- used_marks + n
      put_evaluation("class_mean", sapply(x, function(one) if (length(one)) mean(one) else NA_real_),
                     group = classes, model = model, index = index)
      m_of_index <- c(m_of_index, m$mean)
    }
    put_evaluation("N_eq27", sum(v * m_of_index) / sum(v), model = model)
    put_evaluation("marks_used", used_marks, model = model)
    put_evaluation("marks_missing", length(unique(evaluation$rater)) * length(indices) - nrow(of_model),
                   model = model)
    all_used_marks <- all_used_marks + used_marks

    # Composite of a rater: mean of the marks by index weight, for raters with a mark for every index.
    asked <- unique(evaluation[evaluation$model == model, c("rater", "class")])
    sheet <- matrix(NA_real_, nrow(asked), length(indices), dimnames = list(asked$rater, indices))
    sheet[cbind(of_model$rater, of_model$index)] <- of_model$mark
    composite <- as.vector(sheet %*% v) / sum(v)
    put_evaluation("composite", composite, item = asked$rater, group = asked$class, model = model)
    complete <- !is.na(composite)
    own <- data.frame(asked[complete, ], score = composite[complete])
    composites[[model]] <- own
    put_evaluation("raters_with_all_marks", nrow(own), model = model)
    if (!all(classes[w > 0] %in% own$class)) next
    m <- weighted_mean(split(own$score, factor(own$class, levels = classes)))
    put_evaluation("composite_M", m$mean, model = model)
    put_evaluation("composite_se_of_M", m$se, model = model)
    reach <- qt(upper_tail, m$df) * m$se
    put_interval("evaluation", "composite_M", m$mean - reach, m$mean + reach, model = model)

    # Box plot after Tukey, with the quartiles of R's type 7.
    q <- quantile(own$score, c(0.25, 0.5, 0.75), type = 7, names = FALSE)
    fence <- 1.5 * (q[3] - q[1])
    inside <- own$score[own$score >= q[1] - fence - 1e-12 & own$score <= q[3] + fence + 1e-12]
    put_evaluation(paste0("composite_", c("lowest", "lower_whisker", "lower_quartile", "median",
                                          "upper_quartile", "upper_whisker", "highest", "plain_mean")),
                   c(min(own$score), min(inside), q, max(inside), max(own$score), mean(own$score)),
                   model = model)
  }

  put_evaluation("marks_used", all_used_marks)
  put_evaluation("marks_missing", length(unique(evaluation$rater)) * length(indices) * length(models) -
                   sum(!is.na(evaluation$mark)))
  put_evaluation("composites", sum(sapply(composites, nrow)))
  asked <- unique(evaluation[c("rater", "class")])
  for (class in classes[classes %in% asked$class]) {
    put_evaluation("composites", sum(sapply(composites, function(one) sum(one$class == class))),
                   group = class)
  }

  # Do the raters rank the models alike? Friedman's test; Kendall's W is the same statistic as a share.
  both <- Reduce(intersect, lapply(composites, function(one) one$rater))
  if (length(models) > 1 && length(both) > 1) {
    blocks <- for_ranks(sapply(composites, function(one) one$score[match(both, one$rater)]))
    test <- friedman.test(blocks)
    put_evaluation("models_friedman_chi_squared", unname(test$statistic))
    put_evaluation("models_friedman_df", unname(test$parameter))
    put_evaluation("models_friedman_p", test$p.value)
    put_evaluation("models_kendall_w", unname(test$statistic) / (length(both) * (length(models) - 1)))
    put_evaluation("composites_ranked", length(both) * length(models))
    put_evaluation("mean_rank", colMeans(t(apply(blocks, 1, rank))), model = models)
  }

  # Differences between two models: each rater against himself or herself, the mean by class weight.
  pairs <- pairs_of(length(models))
  difference <- error <- df <- rep(NA_real_, nrow(pairs))
  for (i in seq_len(nrow(pairs))) {
    first <- composites[[models[pairs[i, 1]]]]
    second <- composites[[models[pairs[i, 2]]]]
    d <- first$score - second$score[match(first$rater, second$rater)]
    by_class <- split(d[!is.na(d)], factor(first$class[!is.na(d)], levels = classes))
    if (all(lengths(by_class)[w > 0] >= 2)) {
      m <- weighted_mean(by_class)
      difference[i] <- m$mean
      error[i] <- m$se
      df[i] <- m$df
    }
  }
  defined <- !is.na(error) & error > 0
  p <- ifelse(defined, 2 * pt(-abs(difference / error), df), 1)
  adjusted <- holm(difference, error, df, p)
  names_of_pairs <- paste(models[pairs[, 1]], "-", models[pairs[, 2]])
  put_evaluation("composite_difference", ifelse(defined, difference, NA), model = names_of_pairs)
  put_interval("evaluation", "composite_difference_holm", adjusted$lower[defined], adjusted$upper[defined],
               model = names_of_pairs[defined])
  put_evaluation("composite_difference_p_holm", adjusted$p[defined], model = names_of_pairs[defined])
}

# ---- The training study: people, groups, occasions -----------------------------------------------------

put_training <- function(...) put("training", ...)

people <- facts("participants", "withdrew")
people <- people[people$item != "all", c("item", "group")]
people <- unique(rbind(people, setNames(marks[c("trainee", "group")], c("item", "group"))))
people <- people[order(people$item, method = "radix"), ]
planned_groups <- facts("participants", "withdrew")
groups <- unique(c(planned_groups$group[planned_groups$item == "all" & planned_groups$group != ""],
                   marks$group))
occasions <- unique(marks$occasion)
last <- length(occasions)
raters <- in_order(marks$rater)
trainees <- in_order(marks$trainee)
group_of <- people$group[match(trainees, people$item)]

# Marks at each occasion: one row a trainee, one column a rater, NA where there is no mark.
marks_at <- lapply(occasions, function(occasion) {
  here <- marks[marks$occasion == occasion, ]
  table <- matrix(NA_real_, length(trainees), length(raters), dimnames = list(trainees, raters))
  table[cbind(here$trainee, here$rater)] <- here$mark
  table
})
score_at <- lapply(marks_at, function(x) {
  score <- rowMeans(x, na.rm = TRUE)
  ifelse(is.nan(score), NA, score)
})

# Marks that a trainee lacks, of the number that most trainees have at the occasion (the larger one of two
# numbers that are equally frequent).
usual_number <- function(counts) {
  counts <- counts[counts > 0]
  if (length(counts) == 0) return(0)
  frequency <- table(counts)
  max(as.numeric(names(frequency)[frequency == max(frequency)]))
}
marks_missing <- matrix(0, nrow(people), last)
for (t in seq_along(occasions)) {
  marks_given <- table(factor(marks$trainee[marks$occasion == occasions[t]], levels = people$item))
  marks_missing[, t] <- pmax(0, usual_number(marks_given) - marks_given)
}

# ---- Scores of the trainees and of the groups ----------------------------------------------------------

if (nrow(marks) > 0) {
  put_training("raters", length(raters))
  put_training("marks", nrow(marks))
  put_training("marks_missing", sum(marks_missing))
  scored <- do.call(cbind, lapply(score_at, function(score) !is.na(score)))   # trainees x occasions
  put_training("scores", sum(scored))
  put_training("scores_missing", nrow(people) * last - sum(scored))
  put_training("scores", colSums(scored), occasion = occasions)
  put_training("scores_missing", nrow(people) - colSums(scored), occasion = occasions)
  for (group in groups) {
    put_training("scores", sum(scored[group_of == group, ]), group = group)
    put_training("scores_missing", sum(people$group == group) * last - sum(scored[group_of == group, ]),
                 group = group)
  }
  put_training("marks", as.vector(table(marks$trainee)[trainees]), item = trainees)
  for (t in seq_along(occasions)) {
    occasion <- occasions[t]
    known <- !is.na(score_at[[t]])
    put_training("score", score_at[[t]][known], item = trainees[known], group = group_of[known],
                 occasion = occasion)
    for (group in groups) {
      at <- function(statistic, value) put_training(statistic, value, group = group, occasion = occasion)
      at("marks_missing_at_occasion", sum(marks_missing[people$group == group, t]))
      score <- score_at[[t]][known & group_of == group]
      n <- length(score)
      if (n == 0) next
      x <- marks_at[[t]][known & group_of == group, , drop = FALSE]
      all <- x[!is.na(x)]
      at("mean", mean(score))
      if (n > 1) {
        ends <- mean_interval(score)
        put_interval("training", "mean", ends[1], ends[2], group = group, occasion = occasion)
      }
      at("median", median(score))
      at("min", min(score))
      at("max", max(score))
      at("variance_of_scores_divisor_n", mean((score - mean(score))^2))
      at("variance_of_scores_divisor_n_minus_1", var(score))
      at("standard_deviation_of_scores", sd(score))
      at("variance_of_all_marks_divisor_n", mean((all - mean(all))^2))
      at("mean_between_rater_variance_divisor_n_minus_1", mean(apply(x, 1, var, na.rm = TRUE)))
    }
  }
}

# ---- Agreement of the raters ---------------------------------------------------------------------------

put_agreement <- function(...) put("agreement", ...)

# Mean squares of trainees, raters and rest of a complete table (two-way layout with one mark a cell).
mean_squares <- function(x) {
  n <- nrow(x)
  k <- ncol(x)
  rest <- x - outer(rowMeans(x), colMeans(x), "+") + mean(x)
  list(n = n, k = k, trainees = k * sum((rowMeans(x) - mean(x))^2) / (n - 1),
       raters = n * sum((colMeans(x) - mean(x))^2) / (k - 1), rest = sum(rest^2) / ((n - 1) * (k - 1)))
}

# Interval of ICC(2,1) after McGraw and Wong (1996), table 7, with Satterthwaite's degrees of freedom.
icc_interval <- function(n, k, trainees, raters, rest, df_trainees = n - 1, df_raters = k - 1,
                         df_rest = (n - 1) * (k - 1)) {
  icc <- (trainees - rest) / (trainees + (k - 1) * rest + k * (raters - rest) / n)
  a <- k * icc / (n * (1 - icc)) * raters
  b <- (1 + k * icc * (n - 1) / (n * (1 - icc))) * rest
  df <- (a + b)^2 / (a^2 / df_raters + b^2 / df_rest)
  if (is.na(df) || df <= 0 || rest == 0) return(NULL)
  f1 <- qf(upper_tail, df_trainees, df)
  f2 <- qf(upper_tail, df, df_trainees)
  spread <- k * raters + (k * n - k - n) * rest
  c(n * (trainees - f1 * rest) / (f1 * spread + n * trainees),
    n * (f2 * trainees - rest) / (spread + n * f2 * trainees))
}
spearman_brown <- function(one, k) k * one / (1 + (k - 1) * one)

# Generalizability study of trainees x raters within groups (Brennan 2001), for trainees with a mark from every
# rater. NULL if no group has two of them.
g_study_within <- function(x) {
  present <- colSums(!is.na(x)) > 0
  tables <- lapply(groups, function(group) {
    table <- x[group_of == group, present, drop = FALSE]
    table[rowSums(is.na(table)) == 0, , drop = FALSE]
  })
  tables <- tables[sapply(tables, function(table) nrow(table) > 1 && ncol(table) > 1)]
  if (length(tables) == 0) return(NULL)
  all <- mean_squares(do.call(rbind, tables))
  n <- all$n
  k <- all$k
  df <- c(trainees = n - length(tables), raters = k - 1, rest = (n - 1) * (k - 1))
  within <- sum(sapply(tables, function(table) k * sum((rowMeans(table) - mean(table))^2)))
  ms <- c(trainees = within / df[["trainees"]], raters = all$raters, rest = all$rest)
  variance <- c(trainees = (ms[["trainees"]] - ms[["rest"]]) / k,
                raters = (ms[["raters"]] - ms[["rest"]]) / n, rest = ms[["rest"]])
  component <- pmax(variance, 0)
  list(present = present, variance = variance, component = component,
       dependability = function(number) {
         component[["trainees"]] /
           (component[["trainees"]] + (component[["raters"]] + component[["rest"]]) / number)
       },
       error = function(number) sqrt((component[["raters"]] + component[["rest"]]) / number),
       one_rater = icc_interval(n, k, ms[["trainees"]], ms[["raters"]], ms[["rest"]], df[["trainees"]],
                                df[["raters"]], df[["rest"]]))
}

# Dependability of one rater and of the mean of all, within the groups, and the standard errors of measurement.
put_within <- function(x, ...) {
  present <- colSums(!is.na(x)) > 0
  study <- g_study_within(x)
  put_agreement("trainees_with_every_mark", sum(rowSums(is.na(x[, present, drop = FALSE])) == 0), ...)
  put_one <- function(name, sem, number) {
    known <- !is.null(study) && sum(study$component) > 0
    put_agreement(name, if (known) study$dependability(number) else NA_real_, ...)
    if (!known) return(invisible())
    if (!is.null(study$one_rater)) {
      ends <- spearman_brown(study$one_rater, number)
      put_interval("agreement", name, ends[1], ends[2], ...)
    }
    put_agreement(sem, study$error(number), ...)
  }
  put_one("dependability_of_one_rater", "sem_agreement", 1)
  put_one("dependability_of_all_raters", "sem_of_mean", max(1, sum(present)))
}

# ICC(2,1) and ICC(2,k) of Shrout and Fleiss (1979), and the standard errors of measurement, for trainees
# with a mark from every rater.
put_icc_of_complete <- function(x, ...) {
  put_agreement("trainees_with_every_mark", nrow(x), ...)
  if (nrow(x) < 2 || ncol(x) < 2 || var(rowMeans(x)) <= 1e-13 * var(as.vector(x))) {
    put_agreement("icc_2_1", NA_real_, ...)
    put_agreement("icc_2_k", NA_real_, ...)
    return(invisible())
  }
  ms <- mean_squares(x)
  put_agreement("icc_2_1", with(ms, (trainees - rest) /
                                  (trainees + (k - 1) * rest + k * (raters - rest) / n)), ...)
  put_agreement("icc_2_k", with(ms, (trainees - rest) / (trainees + (raters - rest) / n)), ...)
  ends <- with(ms, icc_interval(n, k, trainees, raters, rest))
  if (!is.null(ends)) {
    put_interval("agreement", "icc_2_1", ends[1], ends[2], ...)
    ends <- spearman_brown(ends, ms$k)
    put_interval("agreement", "icc_2_k", ends[1], ends[2], ...)
  }
  sem <- with(ms, sqrt(max(0, (raters - rest) / n) + rest))
  put_agreement("sem_agreement", sem, ...)
  put_agreement("sem_of_mean", sem / sqrt(ms$k), ...)
}

# Cohen's kappa with quadratic weights of two raters: 1 - observed / expected squared difference.
quadratic_kappa <- function(a, b) {
  expected <- mean(outer(a, b, "-")^2)
  if (length(a) < 2 || expected == 0) return(NA_real_)
  1 - mean((a - b)^2) / expected
}

# Linear mixed model with crossed random trainees and raters, by restricted maximum likelihood. `design`:
# fixed part, one row a mark. Newton's method on the three variances; a variance that would become negative
# is held at 0. df of an estimate after Satterthwaite, from the curvature of the likelihood.
crossed_model <- function(y, trainee, rater, design) {
  z <- list(rest = diag(length(y)), trainees = outer(trainee, trainee, "==") + 0,
            raters = outer(rater, rater, "==") + 0)
  derivatives <- function(variance) {
    inverse <- chol2inv(chol(variance[1] * z[[1]] + variance[2] * z[[2]] + variance[3] * z[[3]]))
    vx <- inverse %*% design
    covariance <- solve(crossprod(design, vx))
    projection <- inverse - vx %*% covariance %*% t(vx)
    py <- as.vector(projection %*% y)
    pz <- lapply(z, function(one) projection %*% one)
    zpy <- lapply(z, function(one) as.vector(one %*% py))
    slope <- sapply(1:3, function(k) sum(diag(pz[[k]])) - sum(py * zpy[[k]]))
    expected <- curvature <- matrix(0, 3, 3)
    for (i in 1:3) for (j in 1:3) {
      expected[i, j] <- sum(pz[[i]] * t(pz[[j]]))
      curvature[i, j] <- 2 * sum(zpy[[i]] * (projection %*% zpy[[j]])) - expected[i, j]
    }
    list(slope = slope, expected = expected, curvature = curvature, covariance = covariance,
         coefficients = as.vector(covariance %*% crossprod(vx, y)),
         covariance_slopes = lapply(z, function(one) covariance %*% t(vx) %*% one %*% vx %*% covariance))
  }
  variance <- rep(var(y) / 3, 3)
  free <- rep(TRUE, 3)
  settled <- FALSE
  for (round in 1:200) {
    at <- derivatives(variance)
    h <- at$curvature[free, free, drop = FALSE]
    if (min(eigen(h, symmetric = TRUE, only.values = TRUE)$values) <= 0) {
      h <- at$expected[free, free, drop = FALSE]   # far from the minimum: Fisher's scoring
    }
    step <- numeric(3)
    step[free] <- -solve(h, at$slope[free])
    following <- variance + step
    if (following[1] <= 0) following <- variance + step * 0.9 * variance[1] / -step[1]
    gone <- which(free & following <= 0)
    if (length(gone) > 0) {
      below <- which(free & variance <= 1e-6 * variance[1] & seq_len(3) > 1)
      if (length(below) > 0) {
        variance[below] <- 0
        free[below] <- FALSE
      } else {
        share <- min(-0.9 * variance[gone] / step[gone])
        variance <- variance + share * step
      }
      next
    }
    change <- max(abs(following - variance)[free] / following[free])
    variance <- following
    if (change < 1e-12) {
      settled <- TRUE
      break
    }
  }
  if (!settled) return(NULL)
  at <- derivatives(variance)
  spread <- 2 * solve(at$curvature[free, free, drop = FALSE])   # of the variances
  estimate <- function(weights) {
    value <- sum(weights * at$coefficients)
    squared <- as.vector(t(weights) %*% at$covariance %*% weights)
    g <- sapply(at$covariance_slopes[free], function(one) as.vector(t(weights) %*% one %*% weights))
    df <- 2 * squared^2 / as.vector(t(g) %*% spread %*% g)
    list(value = value, error = sqrt(squared), df = df, t = value / sqrt(squared),
         p = 2 * pt(-abs(value) / sqrt(squared), df),
         reach = qt(upper_tail, df) * sqrt(squared))
  }
  list(rest = variance[1], trainees = variance[2], raters = variance[3], covariance = at$covariance,
       estimate = estimate)
}

# The same model for the marks of one occasion, with the means of the groups as fixed part.
reliability_at <- function(x) {
  cells <- which(!is.na(x), arr.ind = TRUE)
  if (length(unique(cells[, 2])) < 2 || length(unique(cells[, 1])) < 2) return(NULL)
  complete <- x[rowSums(!is.na(x)) > 0, colSums(!is.na(x)) > 0, drop = FALSE]
  if (!anyNA(complete)) {   # then the mean squares give the same variances, unless one would be negative
    ms <- mean_squares(complete)
    own <- group_of[rowSums(!is.na(x)) > 0]
    means <- rowMeans(complete)
    between <- sum((means - ave(means, own))^2) * ms$k / (ms$n - length(unique(own)))
    model <- with(ms, list(rest = rest, trainees = (between - rest) / k, raters = (raters - rest) / n,
                           usual = k))
    if (!is.finite(between)) return(NULL)
    if (ms$rest > 0 && model$trainees > 0 && model$raters > 0) return(model)
  }
  own <- group_of[cells[, 1]]
  present_groups <- groups[groups %in% own]
  if (length(unique(cells[, 1])) <= length(present_groups)) return(NULL)
  model <- crossed_model(x[!is.na(x)], cells[, 1], cells[, 2], outer(own, present_groups, "==") + 0)
  if (is.null(model)) return(NULL)
  model$usual <- usual_number(rowSums(!is.na(x)))
  model
}

if (nrow(marks) > 0) {
  for (t in seq_along(occasions)) {
    occasion <- occasions[t]
    x <- marks_at[[t]]
    present <- colSums(!is.na(x)) > 0
    put_within(x, occasion = occasion)
    points <- ifelse(x >= 0, floor(x + 0.5), ceiling(x - 0.5))[, present, drop = FALSE]
    pairs <- pairs_of(ncol(points))
    for (group in groups) {
      # A group is judged by all raters who are present at the occasion.
      within <- x[group_of == group, present, drop = FALSE]
      put_icc_of_complete(within[rowSums(is.na(within)) == 0, , drop = FALSE], group = group,
                          occasion = occasion)

      # Every pair of raters, in whole points.
      kappas <- numeric(0)
      apart <- numeric(0)
      for (i in seq_len(nrow(pairs))) {
        both <- points[group_of == group, pairs[i, ], drop = FALSE]
        both <- both[rowSums(is.na(both)) == 0, , drop = FALSE]
        kappas <- c(kappas, quadratic_kappa(both[, 1], both[, 2]))
        apart <- c(apart, abs(both[, 1] - both[, 2]))
      }
      kappas <- kappas[!is.na(kappas)]
      known <- length(kappas) > 0
      put_one <- function(...) put_agreement(..., group = group, occasion = occasion)
      put_one("rater_pairs", nrow(pairs))
      put_one("kappa_quadratic_median", if (known) median(kappas) else NA_real_)
      put_one("kappa_quadratic_lowest", if (known) min(kappas) else NA_real_)
      put_one("kappa_quadratic_highest", if (known) max(kappas) else NA_real_)
      put_one("share_same_point", if (length(apart)) mean(apart == 0) else NA_real_)
      put_one("share_within_one_point", if (length(apart)) mean(apart <= 1) else NA_real_)
    }

    # With missing marks: reliability from the variances of the mixed model.
    if (any(is.na(x[, present]))) {
      put_agreement("trainees_with_marks", length(trainees), occasion = occasion)
      model <- reliability_at(x)
      error <- if (is.null(model)) NA_real_ else model$raters + model$rest
      trainee <- if (is.null(model)) NA_real_ else model$trainees
      usual <- if (is.null(model)) NA_real_ else model$usual
      put_agreement("reml_one_rater", trainee / (trainee + error), occasion = occasion)
      put_agreement("reml_mean", trainee / (trainee + error / usual), occasion = occasion)
      put_agreement("reml_sem_of_one_rater", sqrt(error), occasion = occasion)
      put_agreement("reml_sem_of_mean", sqrt(error / usual), occasion = occasion)
    }
  }

  # Severity of a rater: mark minus the mean of the other raters, first averaged over a trainee's occasions.
  minus_others <- lapply(marks_at, function(x) {
    others <- (rowSums(x, na.rm = TRUE) - ifelse(is.na(x), 0, x)) / (rowSums(!is.na(x)) - !is.na(x))
    ifelse(is.finite(others), x - others, NA)
  })
  trainees_of_raters <- 0
  for (r in seq_along(raters)) {
    own <- rowMeans(sapply(minus_others, function(d) d[, r]), na.rm = TRUE)
    own <- own[!is.nan(own)]
    if (length(own) == 0) next
    trainees_of_raters <- trainees_of_raters + length(own)
    put_agreement("severity_offset", mean(own), item = raters[r])
    if (length(own) > 1) {
      ends <- mean_interval(own)
      put_interval("agreement", "severity_offset", ends[1], ends[2], item = raters[r])
    }
  }

  put_agreement("trainees_of_every_rater", trainees_of_raters)

  # Marks of the raters who gave any at the occasion; the others' marks do not count as missing.
  given_at <- sapply(marks_at, function(x) sum(!is.na(x)))
  lacking_at <- sapply(marks_at, function(x) sum(is.na(x[, colSums(!is.na(x)) > 0, drop = FALSE])))
  put_agreement("marks", given_at, occasion = occasions)
  put_agreement("marks_missing", lacking_at, occasion = occasions)
  put_agreement("marks", sum(given_at))
  put_agreement("marks_missing", sum(lacking_at))

  # Limits of agreement of a rater against the mean of the others (Bland and Altman 1986), at the end, for
  # trainees with a mark from every rater.
  end <- occasions[last]
  x <- marks_at[[last]]
  present <- colSums(!is.na(x)) > 0
  complete <- rowSums(is.na(x[, present, drop = FALSE])) == 0
  for (r in seq_along(raters)) {
    d <- minus_others[[last]][complete, r]
    if (!present[r] || sum(complete) < 2 || sum(present) < 2) {
      put_agreement("limit_of_agreement", NA_real_, item = raters[r], occasion = end)
      next
    }
    put_agreement("mean_difference_from_others", mean(d), item = raters[r], occasion = end)
    put_interval("agreement", "limit_of_agreement", mean(d) - 1.96 * sd(d), mean(d) + 1.96 * sd(d),
                 level = "", item = raters[r], occasion = end)
  }

  # The limit for one more rater against the usual number of others, from the variances of the mixed model.
  model <- reliability_at(x)
  if (!is.null(model) && model$usual >= 2) {
    others <- model$usual - 1
    put_agreement("usual_number_of_others", others, occasion = end)
    put_agreement("limit_against_others", 1.96 * sqrt((model$raters + model$rest) * (1 + 1 / others)),
                  occasion = end)
  }
  for (i in seq_along(trainees)) {
    d <- minus_others[[last]][i, ]
    known <- !is.na(d)
    put_agreement("mean_of_mark_and_others", (x[i, ] - d / 2)[known], item = trainees[i],
                  index = raters[known], occasion = end)
    put_agreement("mark_minus_others", d[known], item = trainees[i], index = raters[known], occasion = end)
  }

  put_agreement("marks_with_others", sum(!is.na(minus_others[[last]])), occasion = end)

  # Raters who marked at one end of the study only, or not every group at the end.
  at_start <- colSums(!is.na(marks_at[[1]])) > 0
  at_end <- colSums(!is.na(x)) > 0
  put_agreement("raters_absent", sum(at_end & !at_start), occasion = occasions[1])
  if (last > 1) put_agreement("raters_absent", sum(at_start & !at_end), occasion = end)
  here <- unique(marks[marks$occasion == end, c("rater", "group")])
  put_agreement("raters_of_some_groups", sum(table(here$rater) < length(unique(here$group))),
                occasion = end)

  # How many raters are needed: the lower limit of the dependability must reach 0.8.
  study <- if (length(raters) > 1) g_study_within(x)
  if (!is.null(study)) {
    put_agreement("variance_of_trainees", study$variance[["trainees"]], occasion = end)
    put_agreement("variance_of_raters", study$variance[["raters"]], occasion = end)
    put_agreement("variance_of_rest", study$variance[["rest"]], occasion = end)
    fewest <- function(reaches) {
      enough <- which(sapply(1:100, reaches))
      if (length(enough) > 0) enough[1] else NA_real_
    }
    put_agreement("raters_needed", fewest(function(number) {
      !is.null(study$one_rater) && isTRUE(spearman_brown(study$one_rater[1], number) >= 0.8)
    }), occasion = end)
    put_agreement("raters_needed_by_estimate", fewest(function(number) {
      isTRUE(study$dependability(number) >= 0.8)
    }), occasion = end)
    for (number in sort(unique(c(1, 2, 3, 5, 10, sum(present))))) {
      at <- function(statistic, value) {
        put_agreement(statistic, value, index = paste("raters", number), occasion = end)
      }
      at("dependability", study$dependability(number))
      if (!is.null(study$one_rater)) {
        ends <- spearman_brown(study$one_rater, number)
        put_interval("agreement", "dependability", ends[1], ends[2], index = paste("raters", number),
                     occasion = end)
      }
      at("generalizability", study$component[["trainees"]] /
           (study$component[["trainees"]] + study$component[["rest"]] / number))
      at("standard_error_of_mean_mark", study$error(number))
    }
  }
}

# ---- Raters on one scale: many-facet Rasch model -------------------------------------------------------

# Rating scale model of Andrich (1978) with a severity for each rater (Linacre 1989), by joint maximum
# likelihood: log(P[k] / P[k-1]) = ability - severity - threshold[k]. Severities and thresholds sum to 0.
# `category`: trainees x raters, 0 to `highest`. Trainees and raters with extreme marks only have no
# estimate. Newton's method.
rasch <- function(category, highest) {
  persons <- seq_len(nrow(category))
  judges <- seq_len(ncol(category))
  repeat {   # leave out those whose marks are all lowest or all highest
    x <- category[persons, judges, drop = FALSE]
    extreme <- function(row) {
      row <- row[!is.na(row)]
      length(row) == 0 || all(row == 0) || all(row == highest)
    }
    keep_persons <- !apply(x, 1, extreme)
    keep_judges <- !apply(x, 2, extreme)
    if (all(keep_persons) && all(keep_judges)) break
    persons <- persons[keep_persons]
    judges <- judges[keep_judges]
    if (length(persons) < 2 || length(judges) < 2) return(NULL)
  }
  if (!setequal(unique(x[!is.na(x)]), 0:highest)) return(NULL)
  # Raters who share no trainee, not even by way of others, are on no common scale: centres that rate apart.
  reached <- 1
  repeat {
    met <- rowSums(!is.na(x[, reached, drop = FALSE])) > 0
    more <- which(colSums(!is.na(x[met, , drop = FALSE])) > 0)
    if (length(more) == length(reached)) break
    reached <- more
  }
  if (length(reached) < ncol(x)) return(NULL)
  cells <- which(!is.na(x), arr.ind = TRUE)
  i <- factor(cells[, 1], levels = seq_along(persons))
  j <- factor(cells[, 2], levels = seq_along(judges))
  mark <- x[!is.na(x)]
  n <- length(persons)
  r <- length(judges)
  sum_to_zero <- function(size) rbind(diag(size - 1), rep(-1, size - 1))
  free <- matrix(0, r + highest, r + highest - 2)   # all severities and thresholds from the free ones
  free[1:r, 1:(r - 1)] <- sum_to_zero(r)
  if (highest > 1) free[r + 1:highest, r - 1 + 1:(highest - 1)] <- sum_to_zero(highest)
  passed <- outer(mark, 1:highest, ">=") + 0
  odds <- function(ability, severity, threshold) {
    p <- exp(outer(ability[i] - severity[j], 0:highest) -
               rep(c(0, cumsum(threshold)), each = length(mark)))
    p / rowSums(p)
  }
  by <- function(values, of) rowsum(values, of, reorder = TRUE)
  ability <- numeric(n)
  border <- numeric(ncol(free))
  parts <- function() {
    all <- as.vector(free %*% border)
    list(severity = all[1:r], threshold = all[r + 1:highest])
  }
  likelihood <- function() {
    at <- parts()
    sum(log(odds(ability, at$severity, at$threshold)[cbind(seq_along(mark), mark + 1)]))
  }
  settled <- FALSE
  for (round in 1:200) {
    at <- parts()
    p <- odds(ability, at$severity, at$threshold)
    expectation <- as.vector(p %*% 0:highest)
    variance <- as.vector(p %*% (0:highest)^2) - expectation^2
    # Probability of each threshold being passed, and its covariance with the mark.
    above <- sapply(1:highest, function(s) rowSums(p[, (s:highest) + 1, drop = FALSE]))
    joint <- sapply(1:highest, function(s) {
      rowSums(p[, (s:highest) + 1, drop = FALSE] * outer(-expectation, s:highest, "+"))
    })
    rest <- mark - expectation
    gradient <- c(by(rest, i), t(free) %*% c(-by(rest, j), -colSums(passed - above)))
    both <- -crossprod(above)   # a mark above the higher of two thresholds is also above the lower one
    for (s in 1:highest) for (u in 1:highest) both[s, u] <- both[s, u] + sum(above[, max(s, u)])
    own <- matrix(0, n, r)
    own[cbind(as.integer(i), as.integer(j))] <- variance
    side <- by(joint, j)
    square <- rbind(cbind(diag(colSums(own), r), side), cbind(t(side), both))
    across <- cbind(-own, -by(joint, i)) %*% free
    information <- rbind(cbind(diag(rowSums(own), n), across),
                         cbind(t(across), t(free) %*% square %*% free))
    step <- tryCatch(solve(information, gradient, tol = 1e-300), error = function(e) NULL)
    if (is.null(step) || !all(is.finite(step))) return(NULL)
    before <- likelihood()
    old <- list(ability, border)
    share <- 1
    repeat {
      ability <- old[[1]] + share * step[1:n]
      border <- old[[2]] + share * step[-(1:n)]
      now <- likelihood()
      if (max(abs(step)) < 1e-10 || share < 1e-12) break
      if (is.finite(now) && now >= before - 1e-12 * abs(before)) break
      share <- share / 2
    }
    if (max(abs(step)) < 1e-10) {
      settled <- TRUE
      break
    }
    if (max(abs(ability)) > 1e3) return(NULL)
  }
  if (!settled) return(NULL)
  at <- parts()
  p <- odds(ability, at$severity, at$threshold)
  expectation <- as.vector(p %*% 0:highest)
  variance <- as.vector(p %*% (0:highest)^2) - expectation^2
  rest <- (mark - expectation)^2
  whole <- function(values) {
    all <- rep(NA_real_, ncol(category))
    all[judges] <- values
    all
  }
  list(persons = persons, severity = whole(at$severity),
       error = whole(1 / sqrt(as.vector(by(variance, j)))),
       infit = whole(as.vector(by(rest, j) / by(variance, j))),
       outfit = whole(as.vector(by(rest / variance, j)) / as.vector(table(j))))
}

if (nrow(marks) > 0 && length(raters) > 1) {
  end <- occasions[last]
  as_categories <- function(x) matrix(match(x, sort(unique(x[!is.na(x)]))) - 1, nrow(x), ncol(x))
  category <- as_categories(marks_at[[last]])
  found <- if (all(is.na(category))) NULL else rasch(category, max(category, na.rm = TRUE))
  if (!is.null(found)) {
    put_agreement("rasch_severity", found$severity, item = raters, occasion = end)
    put_agreement("rasch_error", found$error, item = raters, occasion = end)
    put_agreement("rasch_infit", found$infit, item = raters, occasion = end)
    put_agreement("rasch_outfit", found$outfit, item = raters, occasion = end)

    # Joint maximum likelihood exaggerates: severities shrink by (L - 1) / L for L marks a trainee (Wright
    # and Douglas 1977). Intervals by leaving out a group of trainees at a time (jackknife).
    given_marks <- sum(!is.na(category[found$persons, ]))
    each <- given_marks / length(found$persons)
    shrink <- (each - 1) / each
    size <- min(50, nrow(category))
    samples <- NULL
    if (each > 1 && given_marks <= 5000) {
      for (g in seq_len(size) - 1) {
        kept <- as_categories(category[(seq_len(nrow(category)) - 1) %% size != g, , drop = FALSE])
        one <- if (all(is.na(kept)) || max(kept, na.rm = TRUE) < 1) NULL else
          rasch(kept, max(kept, na.rm = TRUE))
        if (!is.null(one) && !anyNA(one$severity)) samples <- rbind(samples, shrink * one$severity)
      }
    }
    resampled <- !is.null(samples) && nrow(samples) >= 3
    if (each > 1 && (resampled || given_marks > 5000)) {
      if (resampled) {
        n <- nrow(samples)
        error <- sqrt((n - 1) / n * colSums(sweep(samples, 2, colMeans(samples))^2))
        reach <- qt(upper_tail, n - 1) * error
      } else {
        reach <- qnorm(upper_tail) * found$error * sqrt(shrink)
      }
      known <- !is.na(found$severity)
      middle <- (found$severity * shrink)[known]
      put_agreement("rasch_severity_corrected", middle, item = raters[known], occasion = end)
      put_interval("agreement", "rasch_severity_corrected", middle - reach[known], middle + reach[known],
                   item = raters[known], occasion = end)
    }
  }
}

# ---- Comparison of the groups: analysis of covariance --------------------------------------------------

end <- if (last > 0) occasions[last] else ""
put_comparison <- function(...) put("comparison", ..., occasion = end)
put_comparison_interval <- function(...) put_interval("comparison", ..., occasion = end)
pair_name <- function(i, j) paste(i, "-", j)

# One test and interval for each pair of groups; `error(i, j)` is the standard error of a difference.
compare_pairs <- function(means, error, df) {
  pairs <- pairs_of(length(means))
  first <- names(means)[pairs[, 1]]
  second <- names(means)[pairs[, 2]]
  difference <- unname(means[pairs[, 1]] - means[pairs[, 2]])
  errors <- mapply(error, pairs[, 1], pairs[, 2])
  p <- 2 * pt(-abs(difference / errors), df)
  adjusted <- holm(difference, errors, df, p)
  reach <- qt(upper_tail, df) * errors
  wide <- qt(1 - (1 - confidence) / 2 / nrow(pairs), df) * errors   # Bonferroni
  data.frame(first, second, pair = pair_name(first, second), difference, error = errors, df = df,
             t = difference / errors, p, p_holm = adjusted$p, holm_lower = adjusted$lower,
             holm_upper = adjusted$upper, lower = difference - reach, upper = difference + reach,
             wide_lower = difference - wide, wide_upper = difference + wide)
}

# Scores at the end by group, adjusted for the scores before: one slope for all groups. NULL if the model
# cannot be fitted.
ancova <- function(group, before, after) {
  group <- factor(group, levels = groups[groups %in% group])
  sizes <- table(group)
  df <- length(after) - nlevels(group) - 1
  within <- function(x) sum((x - ave(x, group))^2)
  if (nlevels(group) < 2 || df <= 0 || within(before) < 1e-20 || within(after) < 1e-20) return(NULL)
  centred <- before - mean(before)
  fit <- lm(after ~ 0 + group + centred)   # the means are those at the mean score before
  if (sum(residuals(fit)^2) <= 1e-14 * within(after)) return(NULL)
  means <- setNames(coef(fit)[seq_len(nlevels(group))], levels(group))
  contrast <- function(i, j) {
    weights <- numeric(length(coef(fit)))
    weights[c(i, j)] <- c(1, -1)
    weights
  }
  error_with <- function(covariance) {
    function(i, j) sqrt(as.vector(contrast(i, j) %*% covariance %*% contrast(i, j)))
  }
  out <- list(fit = fit, group = group, df = df, means = means,
              errors = sqrt(diag(vcov(fit)))[seq_along(means)],
              pairs = compare_pairs(means, error_with(vcov(fit)), df))

  # Standard errors that allow for unequal spreads: HC3 of MacKinnon and White (1985).
  leverage <- hatvalues(fit)
  out$robust <- NULL
  if (all(1 - leverage > 1e-9)) {
    x <- model.matrix(fit)
    bread <- solve(crossprod(x))
    hc3 <- bread %*% crossprod(x * residuals(fit) / (1 - leverage)) %*% bread
    # Degrees of freedom of Bell and McCaffrey (2002): the variance of a difference is a quadratic form e'Ae.
    free <- diag(nrow(x)) - x %*% bread %*% t(x)
    df_of <- function(i, j) {
      a <- as.vector(x %*% bread %*% contrast(i, j))^2 / (1 - leverage)^2
      min(df, sum(a * diag(free))^2 / sum(outer(a, a) * free^2))
    }
    pairs <- pairs_of(length(means))
    out$robust <- compare_pairs(means, error_with(hc3), mapply(df_of, pairs[, 1], pairs[, 2]))
  }
  out
}

# Brown and Forsythe (1974): analysis of variance of the distances from the group medians.
brown_forsythe <- function(x, group) {
  distance <- abs(x - ave(x, group, FUN = median))
  fit <- suppressWarnings(anova(lm(distance ~ group)))
  if (fit["Residuals", "Df"] <= 0 || fit["Residuals", "Sum Sq"] < 1e-24) return(NA_real_)
  fit["group", "Pr(>F)"]
}

# Hedges' g with the exact correction for few trainees; interval from the noncentral t distribution.
hedges_g <- function(x, y) {
  df <- length(x) + length(y) - 2
  pooled <- (sum((x - mean(x))^2) + sum((y - mean(y))^2)) / df
  if (length(x) < 2 || length(y) < 2 || pooled < 1e-24) return(rep(NA_real_, 3))
  scale <- sqrt(1 / length(x) + 1 / length(y))
  d <- (mean(x) - mean(y)) / sqrt(pooled)
  correction <- exp(lgamma(df / 2) - log(df / 2) / 2 - lgamma((df - 1) / 2))
  noncentrality <- function(p) {
    t <- d / scale
    below <- function(ncp) suppressWarnings(pt(t, df, ncp)) - p
    uniroot(below, t + c(-1, 1) * (5 + abs(t)), tol = 1e-13, extendInt = "downX")$root
  }
  correction * c(d, noncentrality(upper_tail) * scale, noncentrality(1 - upper_tail) * scale)
}

# Difference, in standard errors, that a two-sided t test finds with a power of 80 % at Holm's first step.
detectable_errors <- function(df, pairs) {
  critical <- qt(1 - (1 - confidence) / 2 / pairs, df)
  power <- function(errors) {
    pt(critical, df, errors, lower.tail = FALSE) + pt(-critical, df, errors)
  }
  uniroot(function(errors) power(errors) - 0.8, c(0, 30), tol = 1e-13)$root
}

# Differences of groups: score after on score before, group and centre. Fixed centres: least squares, HC3. Random
# ones: restricted maximum likelihood, degrees of freedom after Satterthwaite.
within_centres <- function(group, site, before, after, random) {
  group <- factor(group, levels = groups[groups %in% group])
  site <- factor(site)
  k <- nlevels(group)
  if (k < 2 || nlevels(site) < 2) return(NULL)
  x <- cbind(outer(as.integer(group), seq_len(k), "==") + 0, before - mean(before))
  if (!random) x <- cbind(x, outer(as.integer(site), seq_len(nlevels(site))[-1], "==") + 0)
  n <- length(after)
  df <- n - ncol(x)
  if (df <= 0 || qr(x)$rank < ncol(x)) return(NULL)
  contrast <- function(i, j) {
    weights <- numeric(ncol(x))
    weights[c(i, j)] <- c(1, -1)
    weights
  }
  pairs <- pairs_of(k)
  if (!random) {
    bread <- solve(crossprod(x))
    fit <- as.vector(bread %*% crossprod(x, after))
    rest <- as.vector(after - x %*% fit)
    free <- diag(n) - x %*% bread %*% t(x)
    counts <- diag(free) > 1e-9   # the others are alone at their centre
    squares <- function(i, j) {
      a <- numeric(n)
      a[counts] <- as.vector(x %*% bread %*% contrast(i, j))[counts]^2 / diag(free)[counts]^2
      a
    }
    error <- function(i, j) sqrt(sum(squares(i, j) * rest^2))
    df_of <- function(i, j) {
      a <- squares(i, j)
      min(df, sum(a * diag(free))^2 / sum(outer(a, a) * free^2))
    }
    means <- setNames(fit[seq_len(k)], levels(group))
    return(list(pairs = compare_pairs(means, error, mapply(df_of, pairs[, 1], pairs[, 2])),
                rest = sum(rest^2) / df, between = NULL))
  }
  sizes <- as.vector(table(site))
  sums <- function(m) rowsum(m, as.integer(site))
  at <- function(ratio) {
    shrink <- function(m) m - ((1 - 1 / sqrt(1 + sizes * ratio)) / sizes * sums(m))[as.integer(site), , drop = FALSE]
    xs <- shrink(x)
    ys <- shrink(cbind(after))
    inverse <- solve(crossprod(xs))
    fit <- as.vector(inverse %*% crossprod(xs, ys))
    share <- 1 / (1 + ratio * sizes)
    pulls <- share * sums(x)
    squares <- sum((ys - xs %*% fit)^2)
    left <- share * sums(cbind(after - x %*% fit))
    list(fit = fit, inverse = inverse, pulls = pulls, squares = squares, by_squares = -sum(left^2),
         by_logs = sum(sizes * share) - sum((pulls %*% inverse) * pulls),
         criterion = df * log(squares) + as.numeric(determinant(crossprod(xs))$modulus) + sum(log1p(ratio * sizes)))
  }
  slope <- function(ratio) with(at(ratio), df * by_squares / squares + by_logs)
  grid <- 0.999 * (0:40) / 40
  grid <- grid / (1 - grid)
  best <- which.min(sapply(grid, function(ratio) at(ratio)$criterion))
  ratio <- 0
  if (best > 1 || slope(0) < 0) {
    ratio <- uniroot(slope, c(grid[max(1, best - 1)], grid[min(41, best + 1)]), tol = 1e-14, maxiter = 1e4)$root
  }
  state <- at(ratio)
  rest <- state$squares / df
  bend <- 0
  if (ratio > 0) {
    step <- 0.01 * ratio
    f <- function(other) with(at(other), by_logs + by_squares / rest)
    bend <- (8 * (f(ratio + step) - f(ratio - step)) - (f(ratio + 2 * step) - f(ratio - 2 * step))) / (12 * step)
  }
  mixed <- -state$by_squares / rest^2
  determinant <- bend * df / rest^2 - mixed^2
  own <- function(i, j) as.vector(contrast(i, j) %*% state$inverse %*% contrast(i, j))
  df_of <- function(i, j) {
    if (ratio == 0 || determinant <= 0) return(df)
    by_ratio <- rest * sum((state$pulls %*% state$inverse %*% contrast(i, j))^2)
    v <- own(i, j)
    min(df, (rest * v)^2 * determinant / (by_ratio^2 * df / rest^2 - 2 * by_ratio * v * mixed + v^2 * bend))
  }
  means <- setNames(state$fit[seq_len(k)], levels(group))
  list(pairs = compare_pairs(means, function(i, j) sqrt(rest * own(i, j)), mapply(df_of, pairs[, 1], pairs[, 2])),
       rest = rest, between = ratio * rest)
}

if (last > 1 && nrow(marks) > 0) {
  person_marks <- function(t) {
    x <- marks_at[[t]][match(people$item, trainees), , drop = FALSE]
    dimnames(x) <- NULL
    x
  }
  marks_before <- person_marks(1)
  marks_after <- person_marks(last)
  mean_or_none <- function(x) ifelse(rowSums(!is.na(x)) > 0, rowMeans(x, na.rm = TRUE), NA)
  before <- mean_or_none(marks_before)
  after <- mean_or_none(marks_after)
  missing_before <- marks_missing[, 1]
  missing_after <- marks_missing[, last]
  compared <- !is.na(before) & !is.na(after)
  affected <- !compared | missing_before + missing_after > 0
  patterns <- unique(!is.na(marks_at[[last]]))
  same_raters <- nrow(patterns[rowSums(patterns) > 0, , drop = FALSE]) <= 1
  as_planned <- !any(affected) && same_raters

  of <- people$group[compared]
  result <- ancova(of, before[compared], after[compared])

  # ---- Mixed model for the marks at the end, if marks are missing ----
  mixed <- NULL
  if (!as_planned && length(unique(of)) > 1) {
    cells <- which(!is.na(marks_after) & compared, arr.ind = TRUE)
    present_groups <- groups[groups %in% of]
    centred <- before - mean(before[compared])
    design <- cbind(outer(people$group[cells[, 1]], present_groups, "==") + 0, centred[cells[, 1]])
    model <- if (qr(design)$rank == ncol(design)) {
      crossed_model(marks_after[cells], cells[, 1], cells[, 2], design)
    }
    if (!is.null(model)) {
      k <- length(present_groups)
      unit <- function(i, j = 0) {
        weights <- numeric(k + 1)
        weights[i] <- 1
        weights[j] <- -1
        weights
      }
      pairs <- pairs_of(k)
      estimates <- lapply(seq_len(nrow(pairs)), function(i) model$estimate(unit(pairs[i, 1], pairs[i, 2])))
      column <- function(name) sapply(estimates, function(one) one[[name]])
      adjusted <- holm(column("value"), column("error"), column("df"), column("p"))
      wide <- qt(1 - (1 - confidence) / 2 / nrow(pairs), column("df")) * column("error")
      mixed <- data.frame(pair = pair_name(present_groups[pairs[, 1]], present_groups[pairs[, 2]]),
                          difference = column("value"), error = column("error"), df = column("df"),
                          t = column("t"), p = column("p"), reach = column("reach"), p_holm = adjusted$p,
                          holm_lower = adjusted$lower, holm_upper = adjusted$upper, wide)
    }
  }

  # ---- Comparison within the centres of a pooled record ----
  site <- if (all(grepl("/", people$item[compared]))) sub("/.*", "", people$item)
  names_of_sites <- if (!is.null(site)) in_order(site[compared])
  random <- length(names_of_sites) >= 5
  centres <- if (length(names_of_sites) > 1) {
    within_centres(of, site[compared], before[compared], after[compared], random)
  }

  # ---- The primary analysis ----
  spread_p <- if (is.null(result)) NA else brown_forsythe(residuals(result$fit), result$group)
  robust <- !is.null(result$robust)
  answered <- is.null(mixed) && !is.null(result) && !is.null(centres)
  primary <- if (!is.null(mixed)) mixed else if (answered) centres$pairs else if (robust) {
    result$robust
  } else result$pairs
  if (!is.null(primary)) {
    put_comparison("primary_analysis", if (!is.null(mixed)) "linear mixed model" else if (answered) {
      "analysis of covariance within centres"
    } else if (robust) "analysis of covariance, HC3" else "analysis of covariance")
    usable <- primary[primary$error > 0, ]
    put_comparison("detectable_difference", usable$error * sapply(usable$df, detectable_errors,
                                                                   pairs = nrow(primary)),
                   group = usable$pair)
    put_comparison("marks_missing", sum(missing_before + missing_after))
    put_comparison("marks_at_both_ends", sum(!is.na(marks_at[[1]])) +
                     if (last > 1) sum(!is.na(marks_at[[last]])) else 0)
    put_comparison("trainees_compared", sum(compared))
    put_comparison("trainees_left_out", sum(!compared))

    # Equivalence by two one-sided tests (Schuirmann 1987).
    margin <- as.numeric(facts("comparison", "equivalence_margin")$value)
    if (length(margin) == 1) {
      p <- with(usable, pmax(pt((difference + margin) / error, df, lower.tail = FALSE),
                             pt((margin - difference) / error, df, lower.tail = FALSE)))
      put_comparison("equivalence_p", p, group = usable$pair)
      reach <- with(usable, qt(confidence, df) * error)
      put_comparison_interval("equivalence", usable$difference - reach, usable$difference + reach,
                              level = "_90", group = usable$pair)
    }
  }

  if (!is.null(result)) {
    x <- before[compared]
    y <- after[compared]
    fit <- result$fit
    group <- result$group
    test <- anova(lm(y ~ x), lm(y ~ x + group))
    put_comparison("ancova_df", test$Df[2])
    put_comparison("ancova_df_error", test$Res.Df[2])
    put_comparison("ancova_f", test$F[2])
    put_comparison("ancova_p", test$`Pr(>F)`[2])
    put_comparison("ancova_slope", unname(coef(fit)[["centred"]]))
    varies <- all(tapply(x, group, function(one) diff(range(one)) > 1e-12))
    slopes_fit <- lm(y ~ 0 + group + group:x)
    slopes_p <- NA
    if (varies && df.residual(slopes_fit) > 0) {
      slopes_p <- anova(lm(y ~ 0 + group + x), slopes_fit)$`Pr(>F)`[2]
      put_comparison("ancova_equal_slopes_p", slopes_p)
    }
    reach <- qt(upper_tail, result$df) * result$errors
    put_comparison("adjusted_mean", unname(result$means), group = names(result$means))
    put_comparison_interval("adjusted_mean", unname(result$means - reach), unname(result$means + reach),
                            group = names(result$means))
    of_pairs <- result$pairs
    put_comparison("adjusted_difference", of_pairs$difference, group = of_pairs$pair)
    put_comparison_interval("adjusted_difference", of_pairs$lower, of_pairs$upper, group = of_pairs$pair)
    put_comparison_interval("adjusted_difference_holm", of_pairs$holm_lower, of_pairs$holm_upper,
                            group = of_pairs$pair)
    put_comparison_interval("adjusted_difference_simultaneous", of_pairs$wide_lower, of_pairs$wide_upper,
                            group = of_pairs$pair)
    put_comparison("t", of_pairs$t, group = of_pairs$pair)
    put_comparison("p", of_pairs$p, group = of_pairs$pair)
    put_comparison("p_holm", of_pairs$p_holm, group = of_pairs$pair)
    for (i in seq_len(nrow(of_pairs))) {
      g <- hedges_g(y[group == of_pairs$first[i]], y[group == of_pairs$second[i]])
      put_comparison("hedges_g", g[1], group = of_pairs$pair[i])
      if (!is.na(g[1])) put_comparison_interval("hedges_g", g[2], g[3], group = of_pairs$pair[i])
    }

    # Spread of the residuals, and the comparison that allows for unequal spreads.
    spreads <- tapply(residuals(fit), group, function(one) if (length(one) > 1) sd(one) else 0)
    put_comparison("largest_spread", max(spreads))
    put_comparison("smallest_spread", min(spreads))
    put_comparison("equal_spread_p", spread_p)
    if (!is.null(result$robust)) {
      of_pairs <- result$robust
      put_comparison("robust_difference", of_pairs$difference, group = of_pairs$pair)
      put_comparison_interval("robust_difference", of_pairs$lower, of_pairs$upper, group = of_pairs$pair)
      put_comparison_interval("robust_difference_holm", of_pairs$holm_lower, of_pairs$holm_upper,
                              group = of_pairs$pair)
      put_comparison("robust_error", of_pairs$error, group = of_pairs$pair)
      put_comparison("robust_df", of_pairs$df, group = of_pairs$pair)
      put_comparison("robust_t", of_pairs$t, group = of_pairs$pair)
      put_comparison("robust_p", of_pairs$p, group = of_pairs$pair)
      put_comparison("robust_p_holm", of_pairs$p_holm, group = of_pairs$pair)
    }

    # Separate slopes if the slopes differ: differences at three scores before, and the scores for which a
    # difference is significant (Johnson and Neyman 1936).
    if (isTRUE(slopes_p < 0.05)) {
      names_of <- levels(group)
      slope <- coef(slopes_fit)[length(names_of) + seq_along(names_of)]
      put_comparison("separate_slope", unname(slope), group = names_of)
      baselines <- mean(x) + c(-1, 0, 1) * sd(x)
      df <- df.residual(slopes_fit)
      covariance <- vcov(slopes_fit)
      pairs <- pairs_of(length(names_of))
      differences <- NULL
      for (i in seq_len(nrow(pairs))) {
        pair <- pair_name(names_of[pairs[i, 1]], names_of[pairs[i, 2]])
        at <- function(score) {   # weights of the coefficients
          weights <- numeric(length(coef(slopes_fit)))
          weights[pairs[i, ]] <- c(1, -1)
          weights[length(names_of) + pairs[i, ]] <- c(score, -score)
          weights
        }
        for (score in baselines) {
          error <- sqrt(as.vector(at(score) %*% covariance %*% at(score)))
          differences <- rbind(differences, data.frame(
            pair, score, difference = sum(at(score) * coef(slopes_fit)), error))
        }
        # (level + slope x)^2 = t^2 variance(x) is a quadratic equation in x.
        t <- qt(upper_tail, df)
        zero <- at(0)
        rise <- at(1) - zero
        level <- sum(zero * coef(slopes_fit))
        steep <- sum(rise * coef(slopes_fit))
        form <- function(a, b) as.vector(a %*% covariance %*% b)
        square <- steep^2 - t^2 * form(rise, rise)
        linear <- 2 * level * steep - 2 * t^2 * form(zero, rise)
        constant <- level^2 - t^2 * form(zero, zero)
        discriminant <- linear^2 - 4 * square * constant
        roots <- sort((-linear + c(-1, 1) * sqrt(max(0, discriminant))) / (2 * square))
        low <- scale_of_marks("scale_lowest")   # of the scores that the scale has
        high <- scale_of_marks("scale_highest")
        below <- roots[1] > low    # whether there are scores below the lower root, and above the upper one
        above <- roots[2] < high
        outside <- roots[1] >= high || roots[2] <= low
        named <- sprintf("%.2f", roots)
        put_comparison("separate_slopes_differ", if (discriminant <= 0) {
          if (square > 0 && discriminant < 0) "for every score before" else "for no score before"
        } else if (outside) {
          if (square > 0) "for every score before" else "for no score before"
        } else if (square > 0) {
          if (below && above) sprintf("for a score before below %s or above %s", named[1], named[2])
          else if (below) sprintf("for a score before below %s", named[1])
          else if (above) sprintf("for a score before above %s", named[2])
          else "for no score before"
        } else {
          if (below && above) sprintf("for a score before between %s and %s", named[1], named[2])
          else if (below) sprintf("for a score before above %s", named[1])
          else if (above) sprintf("for a score before below %s", named[2])
          else "for every score before"
        }, group = pair)
      }
      differences$p <- 2 * pt(-abs(differences$difference / differences$error), df)
      reach <- qt(upper_tail, df) * differences$error
      index <- paste("score before", sprintf("%.17g", differences$score))
      at <- function(statistic, value) {
        put_comparison(statistic, value, group = differences$pair, index = index)
      }
      at("separate_slopes_score_before", differences$score)
      at("separate_slopes_difference", differences$difference)
      put_comparison_interval("separate_slopes_difference", differences$difference - reach,
                              differences$difference + reach, group = differences$pair, index = index)
      at("separate_slopes_p", differences$p)
      at("separate_slopes_p_holm", p.adjust(differences$p, "holm"))
    }

    # Normality of the residuals (Shapiro and Wilk 1965, Royston 1995), and the data of their plots.
    rest <- residuals(fit)
    if (length(rest) >= 3 && length(rest) <= 5000 && diff(range(rest)) > 0) {
      test <- shapiro.test(rest)
      put_comparison("residuals_shapiro_wilk_w", unname(test$statistic))
      put_comparison("residuals_shapiro_wilk_p", test$p.value)
    }
    n <- length(rest)
    in_report <- order(as.integer(group))
    place <- integer(n)
    place[in_report][order(for_ranks(rest[in_report]))] <- seq_len(n)
    deviation <- sqrt(sum(rest^2) / result$df)
    put_comparison("ancova_fitted", unname(fitted(fit)), item = people$item[compared], group = of)
    put_comparison("ancova_residual", unname(rest), item = people$item[compared], group = of)
    put_comparison("ancova_normal_quantile", qnorm((place - 0.5) / n) * deviation,
                   item = people$item[compared], group = of)
  }

  # Differences before, in standard deviations within groups.
  x <- before[compared]
  group <- factor(of, levels = groups[groups %in% of])
  df <- length(x) - nlevels(group)
  within <- sum((x - ave(x, group))^2)
  if (nlevels(group) > 1 && df > 0 && within > 1e-20) {
    means <- tapply(x, group, mean)
    pairs <- pairs_of(nlevels(group))
    put_comparison("difference_before_in_sd", as.vector(means[pairs[, 1]] - means[pairs[, 2]]) /
                     sqrt(within / df), group = pair_name(levels(group)[pairs[, 1]],
                                                          levels(group)[pairs[, 2]]))
  }
}

# ---- Training received, and the comparison of those who were trained as planned ------------------------

noted <- function(statistic) {
  rows <- facts("participants", statistic)
  as.numeric(rows$value[match(people$item, rows$item)])
}
planned <- function(statistic) {
  rows <- facts("participants", statistic)
  as.numeric(rows$value[match(people$group, rows$group)])
}
noted_virtual <- noted("noted_virtual_min")
noted_real <- noted("noted_real_min")
noted_rest <- noted("noted_rest_min")
has_notes <- !is.na(noted_virtual)
planned_virtual <- planned("planned_virtual_min")
planned_real <- planned("planned_real_min")
if (any(has_notes) && !anyNA(planned_virtual) && !anyNA(planned_real)) {
  virtual <- ifelse(has_notes, noted_virtual, 0)
  real <- ifelse(has_notes, noted_real, 0)
  of_plan <- ifelse(planned_virtual > 0, virtual, 0) + ifelse(planned_real > 0, real, 0)
  received <- ifelse(
    (planned_virtual == 0 & virtual > 1) | (planned_real == 0 & real > 1), "other_group", ifelse(
    planned_virtual + planned_real > 0 & of_plan == 0, "nothing", ifelse(
    virtual < 0.8 * planned_virtual | real < 0.8 * planned_real,
    ifelse(virtual + real >= 0.8 * (planned_virtual + planned_real), "other_group", "too_little"), ifelse(
    (planned_virtual > 0 & virtual > 1.2 * planned_virtual) |
      (planned_real > 0 & real > 1.2 * planned_real), "too_much", "as_planned"))))
  put("participants", "received", received, item = people$item, group = people$group)
  for (word in c("as_planned", "nothing", "too_little", "too_much", "other_group")) {
    for (group in groups[groups %in% people$group]) {
      put("participants", paste0("received_", word), sum(received[people$group == group] == word),
          group = group)
    }
  }
  if (last > 1 && nrow(marks) > 0 && any(received != "as_planned")) {
    kept <- compared & received == "as_planned"
    result <- ancova(people$group[kept], before[kept], after[kept])
    if (!is.null(result)) {
      of_pairs <- if (is.null(result$robust)) result$pairs else result$robust
      put_comparison("per_protocol_difference", of_pairs$difference, group = of_pairs$pair)
      put_comparison_interval("per_protocol_difference_holm", of_pairs$holm_lower, of_pairs$holm_upper,
                              group = of_pairs$pair)
      put_comparison("per_protocol_p_holm", of_pairs$p_holm, group = of_pairs$pair)
    }
  }
}

# ---- Comparison within the centres of a pooled record ---------------------------------------------------

if (last > 1 && nrow(marks) > 0 && !is.null(site)) {
  of <- people$group[compared]
  at_site <- site[compared]
  b <- before[compared]
  a <- after[compared]
  if (length(names_of_sites) > 1) {
    put_comparison("centres_compared", length(names_of_sites))
    put_comparison("centre_term", if (random) "random, as there are five or more" else
      "fixed, as there are fewer than five")
    found <- centres
    if (!is.null(found)) {
      put_comparison("centre_variance_of_rest", found$rest)
      if (random) put_comparison("centre_variance_of_centres", found$between)
      with(found$pairs, {
        put_comparison("centre_difference", difference, group = pair)
        put_comparison_interval("centre_difference", lower, upper, group = pair)
        put_comparison_interval("centre_difference_holm", holm_lower, holm_upper, group = pair)
        put_comparison("centre_difference_error", error, group = pair)
        put_comparison("centre_difference_df", df, group = pair)
        put_comparison("centre_difference_t", t, group = pair)
        put_comparison("centre_difference_p", p, group = pair)
        put_comparison("centre_difference_p_holm", p_holm, group = pair)
      })
    }
    for (one in names_of_sites) {
      others <- at_site != one
      left <- within_centres(of[others], at_site[others], b[others], a[others], random)
      if (!is.null(left)) {
        put_comparison("difference_without_centre", left$pairs$difference, group = left$pairs$pair, index = one)
        put_comparison_interval("difference_without_centre", left$pairs$lower, left$pairs$upper,
                                group = left$pairs$pair, index = one)
      }
    }

    # Heterogeneity: Cochran's Q; Higgins and Thompson (2002); Paule and Mandel (1982); Viechtbauer (2007).
    cell <- paste(at_site, of, sep = "\t")
    from <- function(x) x - ave(x, cell)
    df <- length(a) - length(unique(cell)) - 1
    xx <- sum(from(b)^2)
    slope <- sum(from(b) * from(a)) / xx
    variance <- (sum(from(a)^2) - slope * sum(from(b) * from(a))) / df
    if (df > 0 && xx > 0 && is.finite(variance) && variance > 0) {
      names_of <- groups[groups %in% of]
      for (i in seq_len(nrow(pairs_of(length(names_of))))) {
        both <- names_of[pairs_of(length(names_of))[i, ]]
        y <- v <- number <- numeric(0)
        where <- character(0)
        for (one in names_of_sites) {
          first <- at_site == one & of == both[1]
          second <- at_site == one & of == both[2]
          if (!any(first) || !any(second)) next
          shift <- mean(b[first]) - mean(b[second])
          y <- c(y, mean(a[first]) - mean(a[second]) - slope * shift)
          v <- c(v, variance * (1 / sum(first) + 1 / sum(second) + shift^2 / xx))
          where <- c(where, one)
        }
        if (length(y) < 2) next
        pair <- pair_name(both[1], both[2])
        k <- length(y) - 1
        weighted <- function(tau) sum(y / (v + tau)) / sum(1 / (v + tau))
        q <- function(tau) sum((y - weighted(tau))^2 / (v + tau))
        tau_at <- function(value) {
          if (q(0) <= value) return(0)
          high <- 1
          while (q(high) > value) high <- 2 * high
          uniroot(function(tau) q(tau) - value, c(0, high), tol = 1e-15, maxiter = 1e4)$root
        }
        tau <- tau_at(k)
        put_comparison("heterogeneity_q", q(0), group = pair)
        put_comparison("heterogeneity_p", pchisq(q(0), k, lower.tail = FALSE), group = pair)
        put_comparison("heterogeneity_i_squared", max(0, (q(0) - k) / q(0)), group = pair)
        put_comparison("heterogeneity_tau_squared", tau, group = pair)
        put_comparison_interval("heterogeneity_tau_squared", tau_at(qchisq(upper_tail, k)),
                                tau_at(qchisq(1 - upper_tail, k)), group = pair)
        reach <- qt(upper_tail, k) / sqrt(sum(1 / (v + tau)))
        put_comparison("average_over_centres", weighted(tau), group = pair)
        put_comparison_interval("average_over_centres", weighted(tau) - reach, weighted(tau) + reach, group = pair)
        put_comparison("difference_at_centre", y, group = pair, index = where)
        put_comparison_interval("difference_at_centre", y - qt(upper_tail, df) * sqrt(v),
                                y + qt(upper_tail, df) * sqrt(v), group = pair, index = where)
      }
    }
  }
}

# ---- Course over the occasions -------------------------------------------------------------------------

if (last > 1 && nrow(marks) > 0) {
  # Scores of the trainees who have one at every occasion, by group.
  scores <- sapply(score_at, function(score) score[match(people$item, trainees)])
  scores <- matrix(scores, nrow(people), last)
  complete <- rowSums(is.na(scores)) == 0
  courses <- lapply(groups, function(group) scores[complete & people$group == group, , drop = FALSE])
  filled <- courses[sapply(courses, nrow) > 0]
  k <- length(filled)
  sizes <- sapply(filled, nrow)
  n <- sum(sizes)

  # Analysis of variance with the groups between and the occasions within trainees. The occasions' sum of
  # squares is that of unweighted group means (type III); corrected for sphericity after Greenhouse and
  # Geisser (1959); effect sizes after Olejnik and Algina (2003).
  if (k > 0 && n - k >= last - 1) {
    cell <- t(sapply(filled, colMeans))
    of_group <- rowMeans(cell)
    grand <- sum(sizes * of_group) / n
    of_time <- colSums(sizes * cell) / n
    plain <- colMeans(cell)
    ss <- c(group = last * sum(sizes * (of_group - grand)^2),
            time = k^2 / sum(1 / sizes) * sum((plain - mean(plain))^2),
            interaction = sum(sizes * (cell - outer(of_group, of_time, "+") + grand)^2))
    residual <- do.call(rbind, lapply(seq_len(k), function(g) {
      x <- filled[[g]]
      x - outer(rowMeans(x), cell[g, ] - of_group[g], "+")
    }))
    ss_subjects <- last * sum(mapply(function(x, mean) sum((rowMeans(x) - mean)^2), filled, of_group))
    ss_error <- sum(residual^2)
    df_subjects <- n - k
    df_error <- df_subjects * (last - 1)
    s <- crossprod(residual) / df_subjects
    epsilon <- sum(diag(s))^2 / ((last - 1) * sum(s^2))
    put_effect <- function(name, ss, df, ss_error, df_error, other_error, within) {
      f <- ss / df / (ss_error / df_error)
      at <- function(statistic, value) put_comparison(paste0(name, statistic), value)
      at("_f", f)
      at("_df", df)
      at("_df_error", df_error)
      at("_p", pf(f, df, df_error, lower.tail = FALSE))
      if (within) {
        at("_p_greenhouse_geisser", pf(f, epsilon * df, epsilon * df_error, lower.tail = FALSE))
      }
      at("_generalised_eta_squared", ss / (ss + ss_error + other_error))
    }
    if (ss_error > 1e-20 && ss_subjects > 1e-20) {
      if (k > 1) {
        put_effect("mixed_interaction", ss[["interaction"]], (k - 1) * (last - 1), ss_error, df_error,
                   ss_subjects, TRUE)
        put_effect("mixed_group", ss[["group"]], k - 1, ss_subjects, df_subjects, ss_error, FALSE)
      }
      put_effect("mixed_time", ss[["time"]], last - 1, ss_error, df_error, ss_subjects, TRUE)
      put_comparison("trainees_without_every_score", sum(!complete))
      put_comparison("greenhouse_geisser_epsilon", epsilon)
    }
  }

  # ---- Missing marks: the mixed model, and bounds ----
  if (!is.null(mixed)) {
    put_comparison("mixed_model_marks", nrow(cells))
    put_comparison("mixed_model_trainees", sum(compared))
    # F test of the groups with the degrees of freedom of Fai and Cornelius (1996).
    contrasts <- t(sapply(2:length(present_groups), function(g) unit(1, g)))
    axes <- eigen(contrasts %*% model$covariance %*% t(contrasts), symmetric = TRUE)$vectors
    along <- lapply(seq_len(ncol(axes)), function(m) model$estimate(as.vector(axes[, m] %*% contrasts)))
    q <- length(along)
    f <- mean(sapply(along, function(one) one$t^2))
    df <- sapply(along, function(one) one$df)
    whole <- sum(df / (df - 2))
    df_error <- if (diff(range(df)) < 1e-8) mean(df) else if (min(df) > 2) 2 * whole / (whole - q) else NA
    if (!is.na(df_error)) {
      put_comparison("mixed_model_group_df", q)
      put_comparison("mixed_model_group_df_error", df_error)
      put_comparison("mixed_model_group_f", f)
      put_comparison("mixed_model_group_p", pf(f, q, df_error, lower.tail = FALSE))
    }
    put_comparison("mixed_model_variance_of_trainees", model$trainees)
    put_comparison("mixed_model_variance_of_raters", model$raters)
    put_comparison("mixed_model_variance_of_rest", model$rest)
    slope <- model$estimate(unit(length(present_groups) + 1))
    put_comparison("mixed_model_slope", slope$value)
    put_comparison_interval("mixed_model_slope", slope$value - slope$reach, slope$value + slope$reach)
    for (g in seq_along(present_groups)) {
      one <- model$estimate(unit(g))
      put_comparison("mixed_model_adjusted_mean", one$value, group = present_groups[g])
      put_comparison_interval("mixed_model_adjusted_mean", one$value - one$reach, one$value + one$reach,
                              group = present_groups[g])
    }
    put_comparison("mixed_model_difference", mixed$difference, group = mixed$pair)
    put_comparison_interval("mixed_model_difference", mixed$difference - mixed$reach,
                            mixed$difference + mixed$reach, group = mixed$pair)
    put_comparison_interval("mixed_model_difference_holm", mixed$holm_lower, mixed$holm_upper,
                            group = mixed$pair)
    put_comparison_interval("mixed_model_difference_simultaneous", mixed$difference - mixed$wide,
                            mixed$difference + mixed$wide, group = mixed$pair)
    put_comparison("mixed_model_t", mixed$t, group = mixed$pair)
    put_comparison("mixed_model_df", mixed$df, group = mixed$pair)
    put_comparison("mixed_model_p", mixed$p, group = mixed$pair)
    put_comparison("mixed_model_p_holm", mixed$p_holm, group = mixed$pair)
  }

  # Bounds: the missing marks at the end of one group of a pair are all the lowest of the scale, those of the
  # other all the highest. A missing score before is the mean of the known ones.
  if (any(affected)) {
    bound <- function(low, high) {
      in_pair <- people$group %in% c(low, high)
      extra <- ifelse(in_pair, missing_after, 0)
      as <- ifelse(people$group == low, scale_of_marks("scale_lowest"), scale_of_marks("scale_highest"))
      number <- rowSums(!is.na(marks_after)) + extra
      score <- (rowSums(marks_after, na.rm = TRUE) + extra * as) / number
      start <- ifelse(is.na(before), mean(before, na.rm = TRUE), before)
      kept <- number > 0 & !is.na(start)
      result <- ancova(people$group[kept], start[kept], score[kept])
      if (is.null(result)) return(NULL)
      found <- result$pairs[(result$pairs$first == low & result$pairs$second == high) |
                              (result$pairs$first == high & result$pairs$second == low), ]
      if (nrow(found) == 1) found else NULL
    }
    pairs <- pairs_of(length(groups))
    open <- 0
    for (i in seq_len(nrow(pairs))) {
      g <- groups[pairs[i, 1]]
      h <- groups[pairs[i, 2]]
      ends <- list(bound_worst = bound(g, h), bound_best = bound(h, g))
      for (name in names(ends)) {
        one <- ends[[name]]
        put_comparison(name, if (is.null(one)) NA_real_ else one$difference, group = pair_name(g, h))
        if (!is.null(one)) put_comparison_interval(name, one$lower, one$upper, group = pair_name(g, h))
      }
      settled <- !is.null(ends[[1]]) && !is.null(ends[[2]]) &&
        !(ends[[1]]$lower <= 0 && ends[[2]]$upper >= 0)
      open <- open + (!settled && pair_name(g, h) %in% primary$pair)
    }
    if (nrow(pairs) > 0) put_comparison("pairs_left_open", open)
    put_comparison("marks_missing_before", missing_before[affected], item = people$item[affected],
                   group = people$group[affected])
    put_comparison("marks_missing_at_the_end", missing_after[affected], item = people$item[affected],
                   group = people$group[affected])
    put_comparison("compared", as.numeric(compared[affected]), item = people$item[affected],
                   group = people$group[affected])
  }

  # ---- Gains by ranks -----------------------------------------------------------------------------------

  # Exact distribution of the sum of `size` of the doubled ranks (ties included), by counting.
  subset_sums <- function(ranks, size) {
    ways <- matrix(0, size + 1, sum(ranks) + 1)
    ways[1, 1] <- 1
    for (rank in ranks) {
      for (taken in rev(seq_len(size))) {
        from <- ways[taken, seq_len(ncol(ways) - rank)]
        ways[taken + 1, rank + seq_along(from)] <- ways[taken + 1, rank + seq_along(from)] + from
      }
    }
    ways[size + 1, ] / choose(length(ranks), size)
  }
  mann_whitney <- function(x, y) {   # shares of pairs in which x is greater, and the exact p value
    ranks <- 2 * rank(c(x, y))
    if (length(unique(ranks)) < 2) return(c(NA_real_, NA_real_))
    u <- sum(ranks[seq_along(x)]) / 2 - length(x) * (length(x) + 1) / 2
    superiority <- u / (length(x) * length(y))
    if (choose(length(ranks), length(x)) > 2^53) return(c(superiority, NA_real_))   # too many to count
    sum_of_x <- sum(ranks[seq_along(x)])
    middle <- length(x) * (length(ranks) + 1)
    p <- subset_sums(ranks, length(x))
    far <- abs(seq_along(p) - 1 - middle) >= abs(sum_of_x - middle)
    c(superiority, sum(p[far]))
  }
  # Wilcoxon's signed ranks without zero gains; p over all assignments of signs, ties included.
  signed_rank <- function(d) {
    d <- d[d != 0]
    if (length(d) == 0) return(c(NA_real_, NA_real_))
    ranks <- 2 * rank(abs(d))
    p <- 1
    for (one in ranks) p <- (c(p, numeric(one)) + c(numeric(one), p)) / 2
    total <- sum(ranks)
    positive <- sum(ranks[d > 0])
    far <- abs(2 * (seq_along(p) - 1) - total) >= abs(2 * positive - total)
    c(positive / 2, min(1, sum(p[far])))
  }

  gain <- for_ranks(after - before)
  gains <- lapply(groups, function(group) gain[compared & people$group == group])
  for (g in seq_along(groups)) {
    own <- gains[[g]]
    defined <- length(own) >= 3 && length(unique(own)) > 1
    put_comparison("median_gain", if (defined) median(own) else NA_real_, group = groups[g])
    ranks <- signed_rank(own)
    put_comparison("gain_signed_rank_v", ranks[1], group = groups[g])
    put_comparison("gain_signed_rank_p", ranks[2], group = groups[g])
    course <- for_ranks(courses[[g]])
    p <- if (nrow(course) > 1) friedman.test(course)$p.value else NA_real_
    put_comparison("occasions_friedman_p", if (is.nan(p)) NA_real_ else p, group = groups[g])
  }
  leave_out("comparison", c("median_gain_lower_95", "median_gain_upper_95"),
            "bootstrap interval (BCa), which depends on the random numbers drawn")

  # Kruskal and Wallis (1952), Dunn's pairs (1964) with Holm's correction, exact Mann-Whitney tests.
  present <- which(lengths(gains) > 0)
  all <- unlist(gains[present])
  of <- factor(rep(groups[present], lengths(gains)[present]), levels = groups[present])
  if (length(present) > 1 && length(unique(all)) > 1) {
    test <- kruskal.test(all, of)
    n <- length(all)
    put_comparison("gain_kruskal_wallis_h", unname(test$statistic))
    put_comparison("gain_kruskal_wallis_p", test$p.value)
    put_comparison("gain_epsilon_squared", unname(test$statistic) / (n - 1))
    mean_rank <- tapply(rank(all), of, mean)
    ties <- table(all)
    variance <- n * (n + 1) / 12 - sum(ties^3 - ties) / (12 * (n - 1))
    pairs <- pairs_of(length(present))
    size <- as.vector(table(of))
    difference <- as.vector(mean_rank[pairs[, 1]] - mean_rank[pairs[, 2]])
    z <- difference / sqrt(variance * (1 / size[pairs[, 1]] + 1 / size[pairs[, 2]]))
    pair <- pair_name(groups[present][pairs[, 1]], groups[present][pairs[, 2]])
    put_comparison("gain_difference_of_mean_ranks", difference, group = pair)
    put_comparison("gain_dunn_z", z, group = pair)
    put_comparison("gain_dunn_p_holm", p.adjust(2 * pnorm(-abs(z)), "holm"), group = pair)
    for (i in seq_len(nrow(pairs))) {
      ranks <- mann_whitney(gains[present][[pairs[i, 1]]], gains[present][[pairs[i, 2]]])
      put_comparison("gain_superiority", ranks[1], group = pair[i])
      put_comparison("gain_mann_whitney_p_exact", ranks[2], group = pair[i])
    }
  }
}

# ---- Recorded runs -------------------------------------------------------------------------------------

# One row a run: the runs of a trainee follow each other, and each begins with its minutes. Runs without
# counted twists (untwisting, other equipment) are not summarised here.
measures$run <- cumsum(measures$statistic == "minutes")
runs <- measures[measures$statistic == "minutes", c("run", "trainee", "group", "model", "when")]
of_runs <- function(statistic) {
  rows <- measures[measures$statistic == statistic & measures$number == "", ]
  rows$value[match(runs$run, rows$run)]
}
runs$minutes <- as.numeric(of_runs("minutes"))
runs$twists <- as.numeric(of_runs("twists"))
runs$on_target <- as.numeric(of_runs("twists_on_target"))
runs$error_deg <- as.numeric(of_runs("mean_absolute_error_deg"))
runs$torque <- as.numeric(of_runs("peak_torque_Nm"))
runs$force <- as.numeric(of_runs("peak_force_N"))
runs$refused <- as.numeric(of_runs("refused_samples"))
runs$outcome <- of_runs("outcome")
twisting <- runs[!is.na(runs$twists), ]

mean_of_known <- function(x) if (any(!is.na(x))) mean(x, na.rm = TRUE) else NA_real_
for (cell in split(twisting, paste(twisting$group, twisting$when, sep = "\t"))) {
  at <- function(statistic, value) {
    put("trial", statistic, value, group = cell$group[1], occasion = cell$when[1])
  }
  at("runs", nrow(cell))
  at("minutes", sum(cell$minutes))
  at("twists", sum(cell$twists))
  at("twists_on_target", sum(cell$on_target))
  at("mean_absolute_error_deg", mean_of_known(cell$error_deg))
  at("mean_peak_torque_Nm", mean_of_known(cell$torque))
  at("mean_peak_force_N", mean_of_known(cell$force))
}

if (nrow(twisting) > 0) put("trial", "runs", nrow(twisting))

# Untwisting and other equipment: in how many runs a quantity is above zero, and its median.
other <- runs[is.na(runs$twists), ]
always <- c("minutes", "refused_samples", "force_cuts", "outcome", "trial", "content_hash")
quantities <- measures[measures$run %in% other$run & !(measures$statistic %in% always) &
                         measures$number == "", c("run", "statistic", "value")]
quantities$value <- as.numeric(quantities$value)
regrips <- quantities[quantities$statistic == "detorse.regrips", ]
least <- quantities[quantities$statistic == "detorse.least_regrips", ]
beyond <- regrips$value - least$value[match(regrips$run, least$run)]
beyond <- data.frame(run = regrips$run, statistic = rep("regrips_beyond_least", nrow(regrips)),
                     value = beyond)
quantities <- rbind(quantities, beyond[!is.na(beyond$value), ])
other$model[other$model != "foreign recording"] <- ""
for (of_model in split(other, other$model)) {
  put("trial", "measured_runs", nrow(of_model), model = of_model$model[1])
}
for (cell in split(other, paste(other$group, other$when, other$model, sep = "\t"))) {
  at <- function(statistic, value) {
    put("trial", statistic, value, group = cell$group[1], occasion = cell$when[1], model = cell$model[1])
  }
  at("measured_runs", nrow(cell))
  found <- quantities[quantities$run %in% cell$run, ]
  for (x in split(found, found$statistic)) {
    at(paste0("above_zero_", x$statistic[1]), sum(x$value > 0))
    at(paste0("median_", x$statistic[1]), median(x$value))
  }
}

# ---- Practice ------------------------------------------------------------------------------------------

put_practice <- function(...) put("practice", ...)

for (group in groups) {
  own <- has_notes & people$group == group
  if (!any(own)) next
  put_practice("mean_noted_virtual_min", mean(noted_virtual[own]), group = group)
  put_practice("mean_noted_real_min", mean(noted_real[own]), group = group)
  put_practice("trainees_who_rested", sum(noted_rest[own] > 0), group = group)
  put_practice("rest_min", sum(noted_rest[own]), group = group)
  recorded <- sum(twisting$minutes[twisting$trainee %in% people$item[people$group == group]])
  put_practice("mean_recorded_virtual_min", recorded / sum(own), group = group)
}

if (any(has_notes)) put_practice("trainees_with_times", sum(has_notes))

# Learning curve of a trainee: error = asymptote + gain * exp(-rate * (twist - 1)), by least squares. For a
# given rate the other two follow from a straight line; the rate is where the squares left no longer fall.
# `asymptote` FALSE holds the asymptote at 0. NA: the errors do not level off within these twists, or the
# squares fall for ever faster rates, because the first twist stands apart from the others.
learning_curve <- function(y, asymptote) {
  x <- seq_along(y)
  at_rate <- function(rate) {
    shape <- exp(-rate * (x - 1))
    line <- lm.fit(cbind(shape, if (asymptote) 1), y)
    list(left = if (asymptote) line$coefficients[[2]] else 0, squares = sum(line$residuals^2),
         slope = sum(line$residuals * line$coefficients[[1]] * (x - 1) * shape))   # of the squares / 2
  }
  slowest <- min(0.01, 0.05 / max(length(y) - 1, 0.05))
  rates <- slowest
  while (tail(rates, 1) * 1.4 < 8 * 1.4) rates <- c(rates, tail(rates, 1) * 1.4)
  squares <- sapply(rates, function(rate) at_rate(rate)$squares)
  best <- which.min(squares)
  if (best == length(rates)) {
    others <- if (asymptote) y[-1] - mean(y[-1]) else y[-1]
    if (sum(others^2) <= squares[best]) return(NA_real_)
  }
  if (best == 1 && asymptote && sum(residuals(lm(y ~ x))^2) <= squares[1]) return(NA_real_)
  around <- c(if (best > 1) rates[best - 1] else slowest / 1000,
              if (best < length(rates)) rates[best + 1] else 100)
  slope <- function(rate) at_rate(rate)$slope
  if (slope(around[1]) * slope(around[2]) > 0) return(NA_real_)
  at_rate(uniroot(slope, around, tol = 1e-16, maxiter = 10000)$root)$left
}
error_left <- function(y) {
  if (length(y) < 8) return(NA_real_)
  left <- learning_curve(y, TRUE)
  if (isTRUE(left < 0)) learning_curve(y, FALSE) else left
}

errors <- measures[measures$statistic == "twist_error_deg", ]
errors$value <- as.numeric(errors$value)
practised <- unique(errors[c("trainee", "group")])
practised <- practised[order(match(practised$group, groups), practised$trainee, method = "radix"), ]
courses_of_errors <- lapply(practised$trainee, function(trainee) errors$value[errors$trainee == trainee])
left <- numeric(0)
for (i in seq_len(nrow(practised))) {
  y <- courses_of_errors[[i]]
  half <- length(y) %/% 2
  at <- function(statistic, value) {
    put_practice(statistic, value, item = practised$trainee[i], group = practised$group[i])
  }
  at("twists", length(y))
  at("twists_on_target", sum(twisting$on_target[twisting$trainee == practised$trainee[i]]))
  at("mean_error_first_half_deg", if (half > 0) mean(y[seq_len(half)]) else NA_real_)
  at("mean_error_second_half_deg", mean(y[seq(half + 1, length(y))]))
  left[i] <- error_left(y)
  at("error_left_deg", left[i])
}
if (length(left) > 0) {
  put_practice("trainees_with_curve", sum(!is.na(left)))
  put_practice("twists", sum(lengths(courses_of_errors)))
}

# Mean error of a group at its n-th twist, as long as at least two trainees made it.
in_means <- 0
for (group in groups) {
  own <- courses_of_errors[practised$group == group]
  for (n in seq_len(max(0, lengths(own)))) {
    y <- unlist(lapply(own, function(one) one[n]))
    y <- y[!is.na(y)]
    if (length(y) < 2) break
    ends <- mean_interval(y)
    in_means <- in_means + length(y)
    put_practice("mean_twist_error_deg", mean(y), group = group, index = n)
    put_interval("practice", "mean_twist_error_deg", max(0, ends[1]), ends[2], group = group, index = n)
  }
}
if (length(left) > 0) put_practice("twists_in_means", in_means)

# How a trainee's error in the second half of the twists goes with the score at the end, within each group.
if (nrow(practised) > 0 && last > 0) {
  second_half <- sapply(courses_of_errors, function(y) mean(y[seq(length(y) %/% 2 + 1, length(y))]))
  at_the_end <- score_at[[last]][match(practised$trainee, trainees)]
  for (group in groups) {
    own <- practised$group == group & !is.na(at_the_end)
    if (!any(own)) next
    x <- second_half[own]
    y <- at_the_end[own]
    varies <- length(unique(x)) > 1 && length(unique(y)) > 1
    r <- if (varies) cor(x, y) else NA_real_
    put_practice("error_score_correlation", r, group = group)
    if (varies && sum(own) > 3 && abs(r) < 1) {
      ends <- tanh(atanh(r) + c(-1, 1) * qnorm(0.975) / sqrt(sum(own) - 3))
      put_interval("practice", "error_score_correlation", ends[1], ends[2], group = group)
    }
  }
}

# ---- Competence: LC-CUSUM ------------------------------------------------------------------------------

# Biau and Porcher (2010): a run passed raises the sum by log((1 - p0) / (1 - p1)), a run failed lowers it by
# log(p1 / p0), never below 0; at the limit the trainee counts as competent. Then the same sum with the
# opposite signs watches for a relapse. The design shipped with the exercises:
adequate <- 0.05
inadequate <- 0.30
limit <- 11.30
correlation <- 0.45   # of the runs of a session
session <- 5          # runs of a session
success <- log((1 - adequate) / (1 - inadequate))
failure <- log(inadequate / adequate)

# Exact probabilities of being declared competent within 1, 2, ... `attempts` runs, and of not counting as
# competent after them, of a trainee who fails the share `rate` of the runs. The rates of the sessions follow
# a beta distribution with mean `rate`; after f failures in m runs of a session the next run fails with
# probability (rate * precision + f) / (precision + m). States: mode, sum, failures in this session.
course_of_competence <- function(rate, attempts, watched) {
  precision <- (1 - correlation) / correlation
  mode <- 1            # 1: learning, 2: competent and watched
  height <- 0
  failures <- 0
  p <- 1
  declared <- not_able <- numeric(attempts)
  for (run in seq_len(attempts)) {
    m <- (run - 1) %% session
    if (m == 0) failures <- 0 * failures
    fails <- (rate * precision + failures) / (precision + m)
    next_mode <- c(mode, mode)
    next_failures <- c(failures + 1, failures)
    next_p <- c(p * fails, p * (1 - fails))
    change <- rep(c(-failure, success), each = length(p)) * ifelse(next_mode == 1, 1, -1)
    next_height <- round(pmax(0, c(height, height) + change), 10)
    reached <- next_height >= limit - 1e-9
    declared[run] <- sum(next_p[reached & next_mode == 1])
    next_height[reached] <- 0
    keep <- rep(TRUE, length(next_p))
    if (watched) next_mode[reached] <- 3 - next_mode[reached] else keep <- !reached
    state <- paste(next_mode, next_height, next_failures)[keep]
    first <- !duplicated(state)
    p <- as.vector(rowsum(next_p[keep], state, reorder = FALSE))
    mode <- next_mode[keep][first]
    height <- next_height[keep][first]
    failures <- next_failures[keep][first]
    not_able[run] <- sum(p[mode == 1])
  }
  list(declared = cumsum(declared), not_able = not_able)
}

verdicts <- facts("competence", "level")
verdict_fact <- function(statistic) {
  rows <- facts("competence", statistic)
  as.numeric(rows$value[match(paste(verdicts$item, verdicts$index), paste(rows$item, rows$index))])
}
if (nrow(verdicts) > 0) {
  # Runs that count, in order: those passed and not passed. A trainee's runs belong to the exercise, which is
  # the name of the phase where somebody has several.
  judged <- runs[runs$outcome %in% c("passed", "not passed"), ]
  several <- any(duplicated(verdicts$item))
  failed_runs <- lapply(seq_len(nrow(verdicts)), function(i) {
    own <- judged[judged$trainee == verdicts$item[i], ]
    own$outcome[!several | own$when == verdicts$index[i]] == "not passed"
  })
  made <- lengths(failed_runs)
  planned_runs <- verdict_fact("planned_attempts")
  able <- verdict_fact("able") == 1
  shown <- !startsWith(verdicts$value, "not shown yet")
  shipped <- all(verdict_fact("design_version") == 0)
  fewest <- ceiling(limit / success - 1e-9)
  # The runs found must be those of the verdict.
  wanted <- suppressWarnings(as.numeric(gsub("[^0-9]", "", verdicts$value)))
  found <- all(sapply(failed_runs, sum) == verdict_fact("failed")) &&
    all(shown | is.na(wanted) | !shipped | made == fewest - wanted)
  at <- function(statistic, value) {
    put("competence", statistic, value, item = verdicts$item, group = verdicts$group,
        index = verdicts$index)
  }
  known <- list()
  odds <- function(rate, attempts, watched = FALSE) {
    name <- paste(rate, watched)
    if (is.null(known[[name]])) {
      known[[name]] <<- course_of_competence(rate, max(made, planned_runs), watched)
    }
    values <- if (watched) known[[name]]$not_able else known[[name]]$declared
    c(if (watched) 1 else 0, values)[attempts + 1]
  }
  if (shipped) {
    at("fewest_attempts", rep(fewest, nrow(verdicts)))
    put("competence", "fewest_runs_needed", fewest)
    for (percent in seq(10, 30, 5)) {
      at(sprintf("declared_if_failing_%d_planned", percent), odds(percent / 100, planned_runs))
    }
  } else {
    leave_out("competence", c("fewest_attempts", "fewest_runs_needed",
                              sprintf("declared_if_failing_%d_planned", seq(10, 30, 5))),
              "a registered design, whose numbers are not in the tables")
  }
  if (found) put("competence", "most_runs_made", max(made))
  if (found) put("competence", "runs_judged", sum(made))
  if (shipped && found) {
    false_pass <- odds(inadequate, made)
    false_fail <- 1 - odds(adequate, made)
    false_alarm <- pmax(0, odds(adequate, made, watched = TRUE) - false_fail)
    at("false_pass", false_pass)
    at("false_fail", false_fail)
    at("false_alarm", false_alarm)
    put("competence", "false_pass_at_most", max(false_pass))
    if (!several) put("competence", "false_fail_at_most", min(1, max(false_fail + false_alarm)))
    for (percent in seq(10, 30, 5)) {
      at(sprintf("declared_if_failing_%d_so_far", percent), odds(percent / 100, made))
    }
    for (i in seq_len(nrow(verdicts))) {
      learning <- TRUE
      height <- 0
      for (run in seq_along(failed_runs[[i]])) {
        up <- if (failed_runs[[i]][run]) -failure else success
        height <- max(0, height + if (learning) up else -up)
        put("competence", "cumulative_sum_of_limit", height / limit, item = verdicts$item[i],
            group = verdicts$group[i], index = run)
        if (height >= limit - 1e-12) {
          learning <- !learning
          height <- 0
        }
      }
    }
  } else {
    leave_out("competence", c("runs_judged", "most_runs_made", "false_pass", "false_fail", "false_alarm",
                              "false_pass_at_most", "false_fail_at_most", "cumulative_sum_of_limit",
                              sprintf("declared_if_failing_%d_so_far", seq(10, 30, 5))),
              "a registered design, or runs that the tables do not tell apart")
  }
  put("competence", "verdicts_on_too_few_runs", sum(!shown))
  for (cell in split(seq_len(nrow(verdicts)), paste(verdicts$index, verdicts$group, sep = "\t"))) {
    put("competence", "competent_and_not",
        sprintf("competent %d, not competent %d, not shown yet %d", sum(able[cell]),
                sum(!able[cell] & shown[cell]), sum(!able[cell] & !shown[cell])),
        group = verdicts$group[cell[1]], index = verdicts$index[cell[1]])
  }
  if (several) {
    leave_out("competence", c("false_fail_at_most", "able_at_every_exercise"),
              "which exercises are required is not in the tables")
  } else if (found) {
    for (group in groups) {
      own <- verdicts$group == group
      if (any(made[own] > 0)) {
        put("competence", "able_at_every_exercise", sum(able[own]), group = group)
      }
    }
  } else {
    leave_out("competence", "able_at_every_exercise", "runs that the tables do not tell apart")
  }
}

# ---- People and record ---------------------------------------------------------------------------------

enrolled <- facts("participants", "withdrew")
enrolled <- enrolled[enrolled$item != "all", ]
if (nrow(enrolled) > 0) {
  put("participants", "trainees", nrow(enrolled))
  put("participants", "groups", length(groups))
  for (group in groups) {
    put("participants", "allocated", sum(enrolled$group == group), group = group)
    for (t in seq_along(occasions)) {   # without marks, nothing is known about the scores
      put("participants", "scored", sum(!is.na(score_at[[t]][group_of == group])), group = group,
          occasion = occasions[t])
    }
  }
}

# The flow of participants at each centre of a pooled record.
if (nrow(enrolled) > 0 && all(grepl("/", enrolled$item))) {
  centre <- sub("/.*", "", enrolled$item)
  scored <- function(t, codes) sum(!is.na(score_at[[t]][trainees %in% codes]))
  for (one in if (length(unique(centre)) > 1) in_order(centre)) {
    for (group in groups) {
      own <- enrolled[centre == one & enrolled$group == group, ]
      at <- function(statistic, value) put("participants", statistic, value, group = group, index = one)
      at("centre_allocated", nrow(own))
      at("centre_withdrew", sum(as.numeric(own$value)))
      at("centre_runs", sum(runs$trainee %in% own$item))
      at("centre_scored_before", scored(1, own$item))
      at("centre_scored_at_the_end", scored(last, own$item))
    }
  }
}
put_record <- function(item, statistic, value, ...) put("record", statistic, value, item = item, ...)
evaluated <- sum(!is.na(evaluation$mark))
if (evaluated > 0) put_record("evaluation_marks", "count", evaluated)
if (nrow(marks) > 0) put_record("training_marks", "count", nrow(marks))
if (nrow(runs) > 0) {
  put_record("recordings", "count", nrow(runs))
  put_record("recordings", "minutes", sum(runs$minutes))
  put_record("recordings", "refused_samples", sum(runs$refused))
}
if (nrow(marks) > 0) {
  put_record("training_marks", "occasions", length(occasions))
  put_record("training_marks", "raters", length(raters))
} else {
  leave_out("participants", "scored", "the marks of the trainees are not in the tables")
  leave_out("record", c("occasions", "raters"), "the marks of the trainees are not in the tables")
}
if (length(models) > 0) {
  put_record("evaluation_marks", "indices", length(indices))
  put_record("evaluation_marks", "missing", sum(is.na(evaluation$mark)))
  put_record("evaluation_marks", "models", length(models))
  for (one in classes) {
    put_record("evaluation_marks", "raters", length(unique(evaluation$rater[evaluation$class == one])),
               group = one)
  }
}
put_record("training_times", "trainees_who_rested", sum(noted_rest[has_notes] > 0))
if (any(noted_virtual[has_notes] > 0)) {
  noted_sum <- sum(noted_virtual[has_notes])
  recorded <- sum(twisting$minutes)
  put_record("training_times", "noted_virtual_min", noted_sum)
  put_record("training_times", "recorded_virtual_min", recorded)
  put_record("training_times", "recorded_share", recorded / noted_sum)
  if (recorded > 0) put_record("training_times", "noted_for_each_recorded", noted_sum / recorded)
}

# ---- What this script recomputes -----------------------------------------------------------------------

# Every number of these kinds that the report contains must have been produced above, unless left out with a
# reason.
kinds_of <- function(section, statistics) paste(section, strsplit(trimws(statistics), "\\s+")[[1]])
methods <- c(
  kinds_of("evaluation", "
    M s2_eq26_divisor_n min max plain_mean population_variance sample_variance class_weighted_moment
    se_of_M se_df class_mean N_eq27 composite raters_with_all_marks marks_used marks_missing composites
    composites_ranked composite_M composite_se_of_M
    composite_M_lower_95 composite_M_upper_95 composite_lowest composite_lower_whisker
    composite_lower_quartile composite_median composite_upper_quartile composite_upper_whisker
    composite_highest composite_plain_mean models_friedman_chi_squared models_friedman_df
    models_friedman_p models_kendall_w mean_rank composite_difference composite_difference_holm_lower_95
    composite_difference_holm_upper_95 composite_difference_p_holm"),
  kinds_of("training", "
    raters marks score marks_missing_at_occasion marks_missing scores scores_missing mean mean_lower_95 mean_upper_95 median min max
    variance_of_scores_divisor_n variance_of_scores_divisor_n_minus_1 standard_deviation_of_scores
    variance_of_all_marks_divisor_n mean_between_rater_variance_divisor_n_minus_1"),
  kinds_of("agreement", "
    trainees_with_every_mark icc_2_1 icc_2_k icc_2_1_lower_95 icc_2_1_upper_95 icc_2_k_lower_95
    icc_2_k_upper_95 sem_agreement sem_of_mean rater_pairs kappa_quadratic_median kappa_quadratic_lowest
    kappa_quadratic_highest share_same_point share_within_one_point dependability_of_one_rater
    dependability_of_one_rater_lower_95 dependability_of_one_rater_upper_95 dependability_of_all_raters
    dependability_of_all_raters_lower_95 dependability_of_all_raters_upper_95
    marks marks_missing marks_with_others trainees_of_every_rater severity_offset
    severity_offset_lower_95 severity_offset_upper_95 mean_difference_from_others
    limit_of_agreement_lower limit_of_agreement_upper usual_number_of_others limit_against_others
    mean_of_mark_and_others mark_minus_others raters_absent raters_of_some_groups variance_of_trainees
    variance_of_raters variance_of_rest raters_needed raters_needed_by_estimate dependability
    dependability_lower_95 dependability_upper_95 generalizability standard_error_of_mean_mark
    rasch_severity rasch_error rasch_infit rasch_outfit rasch_severity_corrected
    rasch_severity_corrected_lower_95 rasch_severity_corrected_upper_95 trainees_with_marks
    reml_one_rater reml_mean reml_sem_of_one_rater reml_sem_of_mean limit_of_agreement"),
  kinds_of("comparison", "
    primary_analysis detectable_difference marks_missing marks_at_both_ends trainees_compared
    trainees_left_out
    equivalence_p equivalence_lower_90 equivalence_upper_90 ancova_df ancova_df_error ancova_f ancova_p
    ancova_slope ancova_equal_slopes_p adjusted_mean adjusted_mean_lower_95 adjusted_mean_upper_95
    adjusted_difference adjusted_difference_lower_95 adjusted_difference_upper_95
    adjusted_difference_holm_lower_95 adjusted_difference_holm_upper_95
    adjusted_difference_simultaneous_lower_95 adjusted_difference_simultaneous_upper_95 t p p_holm
    hedges_g hedges_g_lower_95 hedges_g_upper_95 largest_spread smallest_spread equal_spread_p
    robust_difference robust_difference_lower_95 robust_difference_upper_95 robust_difference_holm_lower_95
    robust_difference_holm_upper_95 robust_error robust_df robust_t robust_p robust_p_holm
    residuals_shapiro_wilk_w residuals_shapiro_wilk_p ancova_fitted ancova_residual
    ancova_normal_quantile difference_before_in_sd mixed_interaction_f mixed_interaction_df
    mixed_interaction_df_error mixed_interaction_p mixed_interaction_p_greenhouse_geisser
    mixed_interaction_generalised_eta_squared mixed_group_f mixed_group_df mixed_group_df_error
    mixed_group_p mixed_group_generalised_eta_squared mixed_time_f mixed_time_df mixed_time_df_error
    mixed_time_p mixed_time_p_greenhouse_geisser mixed_time_generalised_eta_squared
    trainees_without_every_score greenhouse_geisser_epsilon median_gain gain_signed_rank_v
    gain_signed_rank_p occasions_friedman_p gain_kruskal_wallis_h gain_kruskal_wallis_p
    gain_epsilon_squared gain_difference_of_mean_ranks gain_dunn_z gain_dunn_p_holm gain_superiority
    gain_mann_whitney_p_exact separate_slope separate_slopes_differ separate_slopes_score_before
    separate_slopes_difference separate_slopes_difference_lower_95 separate_slopes_difference_upper_95
    separate_slopes_p separate_slopes_p_holm per_protocol_difference
    per_protocol_difference_holm_lower_95 per_protocol_difference_holm_upper_95 per_protocol_p_holm
    mixed_model_marks mixed_model_trainees mixed_model_group_df mixed_model_group_df_error
    mixed_model_group_f mixed_model_group_p mixed_model_variance_of_trainees
    mixed_model_variance_of_raters mixed_model_variance_of_rest mixed_model_slope
    mixed_model_slope_lower_95 mixed_model_slope_upper_95 mixed_model_adjusted_mean
    mixed_model_adjusted_mean_lower_95 mixed_model_adjusted_mean_upper_95 mixed_model_difference
    mixed_model_difference_lower_95 mixed_model_difference_upper_95 mixed_model_difference_holm_lower_95
    mixed_model_difference_holm_upper_95 mixed_model_difference_simultaneous_lower_95
    mixed_model_difference_simultaneous_upper_95 mixed_model_t mixed_model_df mixed_model_p
    mixed_model_p_holm bound_worst bound_worst_lower_95 bound_worst_upper_95 bound_best
    bound_best_lower_95 bound_best_upper_95 pairs_left_open marks_missing_before
    marks_missing_at_the_end compared centres_compared centre_term centre_variance_of_rest centre_variance_of_centres
    centre_difference centre_difference_lower_95 centre_difference_upper_95 centre_difference_holm_lower_95
    centre_difference_holm_upper_95 centre_difference_error centre_difference_df centre_difference_t
    centre_difference_p centre_difference_p_holm difference_without_centre difference_without_centre_lower_95
    difference_without_centre_upper_95 heterogeneity_q heterogeneity_p heterogeneity_i_squared
    heterogeneity_tau_squared heterogeneity_tau_squared_lower_95 heterogeneity_tau_squared_upper_95
    average_over_centres average_over_centres_lower_95 average_over_centres_upper_95 difference_at_centre
    difference_at_centre_lower_95 difference_at_centre_upper_95"),
  kinds_of("participants", "
    received received_as_planned received_nothing received_too_little received_too_much
    received_other_group trainees groups allocated scored centre_allocated centre_withdrew centre_runs
    centre_scored_before centre_scored_at_the_end"),
  kinds_of("trial", "
    runs minutes twists twists_on_target mean_absolute_error_deg mean_peak_torque_Nm mean_peak_force_N
    measured_runs"),
  kinds_of("practice", "
    mean_noted_virtual_min mean_noted_real_min trainees_who_rested rest_min mean_recorded_virtual_min
    twists twists_in_means trainees_with_times twists_on_target mean_error_first_half_deg
    mean_error_second_half_deg error_left_deg
    mean_twist_error_deg mean_twist_error_deg_lower_95 mean_twist_error_deg_upper_95 trainees_with_curve
    error_score_correlation error_score_correlation_lower_95 error_score_correlation_upper_95"),
  kinds_of("competence", "
    fewest_attempts fewest_runs_needed declared_if_failing_10_planned declared_if_failing_15_planned
    declared_if_failing_20_planned declared_if_failing_25_planned declared_if_failing_30_planned
    runs_judged most_runs_made false_pass false_fail false_alarm false_pass_at_most false_fail_at_most
    declared_if_failing_10_so_far declared_if_failing_15_so_far declared_if_failing_20_so_far
    declared_if_failing_25_so_far declared_if_failing_30_so_far cumulative_sum_of_limit
    verdicts_on_too_few_runs competent_and_not able_at_every_exercise"),
  kinds_of("record", "
    count minutes refused_samples occasions raters indices missing models trainees_who_rested
    noted_virtual_min recorded_virtual_min recorded_share noted_for_each_recorded")
)

# ---- Comparison with the report ------------------------------------------------------------------------

recomputed <- do.call(rbind, results)
key_columns <- c("section", "item", "group", "model", "index", "occasion", "statistic")
key_of <- function(table) {
  # The scores before for which separate slopes are compared stand in the key; 12 digits identify them.
  number <- suppressWarnings(as.numeric(sub("^score before ", "", table$index)))
  of_score <- startsWith(table$index, "score before ") & !is.na(number)
  table$index[of_score] <- paste("score before", signif(number[of_score], 12))
  key <- do.call(paste, c(table[key_columns], sep = "\t"))
  times <- ave(seq_along(key), key, FUN = seq_along)   # the sums of several exercises share their keys
  ifelse(times > 1, paste(key, "occurrence", times), key)
}
kind_of <- function(table) paste(table$section, table$statistic)
expected <- read_table("expected.csv")
inputs <- (expected$section == "training" & expected$statistic == "rater_mark") |
  (expected$section == "evaluation" & expected$statistic == "mark") |
  (expected$section == "trial" & expected$item != "all")
computed <- expected[!inputs & !(key_of(expected) %in% key_of(given)), ]

place <- match(key_of(recomputed), key_of(computed))
recomputed$expected <- computed$value[place]
x <- suppressWarnings(as.numeric(recomputed$value))
y <- suppressWarnings(as.numeric(recomputed$expected))
recomputed$difference <- ifelse(is.na(x) | is.na(y), "", sprintf("%.3g", x - y))
recomputed$agrees <- !is.na(place) &
  ifelse(is.na(x) | is.na(y), recomputed$value == recomputed$expected,
         abs(x - y) <= tolerance * pmax(1, abs(y)))
write.csv(recomputed[c(key_columns, "value", "expected", "difference", "agrees")], "recomputed.csv",
          row.names = FALSE, quote = TRUE, na = "")

not_recomputed <- computed[!(key_of(computed) %in% key_of(recomputed)), ]
excused <- kind_of(not_recomputed) %in% kind_of(left_out)
lacking <- not_recomputed[!excused & (kind_of(not_recomputed) %in% methods), ]
unknown <- not_recomputed[!excused & !(kind_of(not_recomputed) %in% methods), ]
unexpected <- recomputed[is.na(place), ]
disagreeing <- recomputed[!is.na(place) & !recomputed$agrees, ]

counted <- function(kinds) {
  if (length(kinds) == 0) return("  none")
  number <- table(factor(kinds, levels = unique(kinds)))
  paste0("  ", names(number), " (", number, ")")
}
say <- function(...) cat(..., "\n", sep = "")
show <- function(lines) {
  cat(paste0("  ", head(gsub("\t", ",", lines), 50)), sep = "\n")
  if (length(lines) > 50) say("  and ", length(lines) - 50, " more")
}
say("Numbers of the report:         ", nrow(expected))
say("  marks and measurements:      ", sum(inputs), "  (input)")
say("  facts that are not computed: ", nrow(given), "  (taken as given)")
say("  computed by Torsio:          ", nrow(computed))
say("  recomputed here:             ", nrow(recomputed), sprintf(
  "  (%.1f %% of those computed)", 100 * sum(!is.na(place)) / max(1, nrow(computed))))
say("  of these agree:              ", sum(recomputed$agrees))
say("\nTaken as given:")
cat(counted(kind_of(given)), sep = "\n")
say("\nNot recomputed:")
if (any(excused) || nrow(unknown) > 0) {
  reasons <- c(left_out$reason[match(kind_of(not_recomputed)[excused], kind_of(left_out))],
               rep("no method in this script", nrow(unknown)))
  kinds <- c(kind_of(not_recomputed)[excused], kind_of(unknown))
  cat(counted(paste0(kinds, ": ", reasons)), sep = "\n")
} else {
  say("  none")
}
if (nrow(disagreeing) > 0) {
  say("\nDo not agree:")
  show(paste0(key_of(disagreeing), ": ", disagreeing$value, " here, ", disagreeing$expected,
              " in the report"))
}
if (nrow(unexpected) > 0) {
  say("\nRecomputed, but not in the report:")
  show(paste0(key_of(unexpected), ": ", unexpected$value))
}
if (nrow(lacking) > 0) {
  say("\nIn the report, but not produced here although there is a method:")
  show(paste0(key_of(lacking), ": ", lacking$value))
}
failed <- nrow(disagreeing) + nrow(unexpected) + nrow(lacking) > 0
say(if (failed) "\nThe numbers do NOT all agree." else "\nAll recomputed numbers agree.")
quit(status = if (failed) 1 else 0)
