# SPDX-License-Identifier: GPL-3.0-or-later
# Functions for the R commands of cases.tsv: the tables, and formulas that no Debian package computes to nine digits.
suppressMessages({library(psych); library(car); library(coin); library(lme4); library(lmerTest)})

rows <- function(name) read.csv(file.path(folder, "tables", paste0(name, ".csv")))
# One row per target, one column per rater, in file order; missing marks are NA.
wide <- function(name) {  # or its rows
  d <- if (is.data.frame(name)) name else rows(name)
  m <- tapply(d$score, list(factor(d$target, unique(d$target)), factor(d$rater, unique(d$rater))), identity)
  matrix(as.numeric(m), nrow(m))
}
of_group <- function(name, group, occasion = NULL) {
  d <- rows(name)
  if (!is.null(occasion)) d <- d[d$occasion == occasion, ]
  d$score[d$group == group]
}
last <- function() { d <- rows("study"); d <- d[d$occasion == "after", ]; d$group <- factor(d$group, unique(d$group)); d }
before_after <- function() {
  d <- rows("study")
  w <- reshape(d, idvar = c("subject", "group"), timevar = "occasion", direction = "wide")
  names(w) <- sub("score.", "", names(w), fixed = TRUE)
  w$group <- factor(w$group, unique(w$group))
  w
}

icc <- function(name, form, what, group = NULL) {
  d <- rows(name)
  r <- psych::ICC(if (is.null(group)) wide(name) else wide(d[d$group == group, ]), lmer = FALSE)$results
  r[r$type == c("ICC(1,1)" = "ICC1", "ICC(2,1)" = "ICC2", "ICC(3,1)" = "ICC3", "ICC(1,k)" = "ICC1k",
                "ICC(2,k)" = "ICC2k", "ICC(3,k)" = "ICC3k")[[form]], what]
}
squares <- function(name) {
  d <- rows(name)
  s <- summary(aov(score ~ factor(target) + factor(rater), d))[[1]]
  c(targets = s[1, 3], raters = s[2, 3], error = s[3, 3])
}
# Krippendorff (2011) by its definition: every pair of marks within a unit against every pair of all.
krippendorff <- function(name, metric) {
  d <- rows(name)
  units <- Filter(function(u) length(u) > 1, split(d$score, d$target))
  all <- unlist(units)
  counts <- table(all)
  values <- as.numeric(names(counts))
  distance <- function(a, b) switch(metric,
    nominal = as.numeric(a != b),
    interval = (a - b)^2,
    ratio = ifelse(a + b == 0, 0, ((a - b) / (a + b))^2),
    ordinal = mapply(function(x, y) {
      lo <- min(x, y); hi <- max(x, y)
      between <- sum(counts[values >= lo & values <= hi])
      if (lo == hi) 0 else (between - (counts[values == lo] + counts[values == hi]) / 2)^2
    }, a, b))
  pairs <- function(v) { g <- expand.grid(i = seq_along(v), j = seq_along(v)); g <- g[g$i != g$j, ]; sum(distance(v[g$i], v[g$j])) }
  observed <- sum(sapply(units, function(u) pairs(u) / (length(u) - 1))) / length(all)
  expected <- pairs(all) / (length(all) * (length(all) - 1))
  1 - observed / expected
}
kendall_w <- function(name) {
  m <- wide(name); n <- nrow(m); k <- ncol(m)
  ranks <- apply(m, 2, rank)
  ties <- sum(apply(m, 2, function(v) sum(table(v)^3 - table(v))))
  12 * sum((rowSums(ranks) - k * (n + 1) / 2)^2) / (k^2 * (n^3 - n) - k * ties)
}
# Fleiss, Cohen & Everitt 1969.
kappa2 <- function(name, a, b, weights) {
  m <- wide(name)[, c(a, b)]; v <- sort(unique(as.vector(wide(name)))); q <- length(v)
  p <- table(factor(m[, 1], v), factor(m[, 2], v)) / nrow(m)
  distance <- abs(outer(seq_len(q), seq_len(q), "-")) / (q - 1)
  w <- switch(weights, unweighted = diag(q), linear = 1 - distance, quadratic = 1 - distance^2)
  r <- rowSums(p); s <- colSums(p)
  po <- sum(w * p); pe <- sum(w * outer(r, s))
  bar <- outer(as.vector(w %*% s), as.vector(r %*% w), "+")
  variance <- (sum(p * (w * (1 - pe) - bar * (1 - po))^2) - (po * pe - 2 * pe + po)^2) / (nrow(m) * (1 - pe)^4)
  null <- (sum(outer(r, s) * (w - bar)^2) - pe^2) / (nrow(m) * (1 - pe)^2)
  k <- (po - pe) / (1 - pe)
  list(kappa = k, error = sqrt(variance), z = k / sqrt(null))
}
fleiss <- function(name) {
  m <- wide(name); v <- sort(unique(as.vector(m)))
  counts <- t(apply(m, 1, function(row) table(factor(row, v)))); n <- ncol(m); N <- nrow(m)
  po <- mean((rowSums(counts^2) - n) / (n * (n - 1))); p <- colSums(counts) / (N * n); pe <- sum(p^2)
  (po - pe) / (1 - pe)
}
exact_permutation <- function(x, y) {  # two-sided, of the difference of means, all splits
  all <- c(x, y); n <- length(x); sums <- combn(length(all), n, function(i) sum(all[i]))
  expected <- n * mean(all)
  mean(abs(sums - expected) >= abs(sum(x) - expected) - 1e-9 * max(abs(all)))
}
exact_signs <- function(d) {
  signs <- as.matrix(expand.grid(rep(list(c(-1, 1)), length(d))))
  sums <- signs %*% abs(d)
  mean(abs(sums) >= abs(sum(d)) - 1e-9)
}
# Hedges & Olkin: exact correction; the interval from the noncentral t distribution.
hedges <- function(x, y, tail = NULL) {
  n <- length(x); m <- length(y); df <- n + m - 2
  s <- sqrt(((n - 1) * var(x) + (m - 1) * var(y)) / df)
  j <- exp(lgamma(df / 2) - lgamma((df - 1) / 2)) / sqrt(df / 2)
  scale <- sqrt(1 / n + 1 / m); t <- (mean(x) - mean(y)) / s / scale
  if (is.null(tail)) return(j * t * scale)
  # R's pt is exact to 1e-12 here, its own root finder stops earlier.
  j * scale * uniroot(function(d) pt(t, df, d) - tail, t + c(-8, 8), tol = 1e-14)$root
}
# Studentised range by Gauss quadrature in R's own integrate: ptukey stops at some 1e-8.
range_of_normals <- function(w, k) k * integrate(function(z) dnorm(z) * (pnorm(z) - pnorm(z - w))^(k - 1), -9, w + 9,
                                                 rel.tol = 1e-13, subdivisions = 2000, stop.on.error = FALSE)$value
studentised_range <- function(q, k, df) {  # upper tail
  of <- function(s) sapply(s, function(u) (1 - range_of_normals(q * u, k)) *
    exp(log(2) + df / 2 * log(df / 2) - lgamma(df / 2) + (df - 1) * log(u) - df * u^2 / 2))
  mode <- sqrt(max(df - 1, 0.1) / df); width <- 12 / sqrt(2 * df)
  edges <- sort(unique(pmax(0, c(0, mode - width / 2, mode - width / 6, mode, mode + width / 6, mode + width / 2, mode + width))))
  sum(mapply(function(a, b) if (b > a) integrate(of, a, b, rel.tol = 1e-12, subdivisions = 500)$value else 0,
             head(edges, -1), tail(edges, -1)))
}
dunn <- function(groups, a, b) {
  all <- unlist(groups); r <- rank(all); n <- length(all)
  of <- rep(seq_along(groups), lengths(groups)); m <- tapply(r, of, mean)
  ties <- sum(table(all)^3 - table(all))
  unname((m[b] - m[a]) / sqrt((n * (n + 1) / 12 - ties / (12 * (n - 1))) * (1 / lengths(groups)[a] + 1 / lengths(groups)[b])))
}
mixed <- function() {
  w <- before_after(); time <- data.frame(time = factor(c("before", "middle", "after"), c("before", "middle", "after")))
  m <- lm(cbind(before, middle, after) ~ group, w, contrasts = list(group = "contr.sum"))
  summary(car::Anova(m, idata = time, idesign = ~time, type = 3), multivariate = FALSE)
}
# A model of four occasions; "fewest": as many degrees of freedom as contrasts.
four <- function(name) {
  w <- reshape(rows(name), idvar = c("subject", "group"), timevar = "occasion", direction = "wide")
  lm(as.matrix(w[, 3:6]) ~ group, w, contrasts = list(group = "contr.sum"))
}
mixed_four <- function(name) summary(car::Anova(four(name), idata = data.frame(time = factor(1:4)), idesign = ~time, type = 3), multivariate = FALSE)
# Anderson (2003), section 10.7.4, p contrasts. stats::mauchly.test has 3 (p + 1) for his 3 p in the second term: from four
# occasions on its error falls with the square of the degrees of freedom, Anderson's with the cube.
mauchly_four <- function(name) {
  m <- four(name); n <- m$df.residual; p <- 3; w <- log(mauchly.test(m, X = ~1)$statistic)
  rho <- 1 - (2 * p^2 + p + 2) / (6 * p * n); f <- p * (p + 1) / 2 - 1
  second <- (p + 2) * (p - 1) * (p - 2) * (2 * p^3 + 6 * p^2 + 3 * p + 2) / (288 * (n * p * rho)^2)
  first <- pchisq(-n * rho * w, f, lower.tail = FALSE)
  first + second * (pchisq(-n * rho * w, f + 4, lower.tail = FALSE) - first)
}
# Box's epsilon, and Huynh & Feldt's as corrected by Lecoutre (1991).
epsilon <- function(corrected = FALSE) {
  w <- before_after(); s <- Reduce("+", lapply(split(w[, c("before", "middle", "after")], w$group), function(g) (nrow(g) - 1) * cov(g)))
  h <- contr.helmert(3); h <- sweep(h, 2, sqrt(colSums(h^2)), "/"); e <- t(h) %*% as.matrix(s) %*% h
  gg <- sum(diag(e))^2 / (2 * sum(e^2)); if (!corrected) return(gg)
  f <- nrow(w) - nlevels(w$group)
  min(1, ((f + 1) * 2 * gg - 2) / (2 * (f - 2 * gg)))
}
# nls stops where the sum of squares no longer falls, at some 1e-9 of the parameters: plain Gauss-Newton steps settle them.
fit <- function(subject, family) {
  d <- rows("seconds"); d <- d[d$subject == subject, ]; t <- d$attempt; y <- d$value
  curve <- if (family == "exponential") deriv(~ c + a * exp(-r * (t - 1)), c("c", "a", "r"), function(c, a, r, t) {})
           else deriv(~ c + a * t^-r, c("c", "a", "r"), function(c, a, r, t) {})
  b <- coef(nls(y ~ curve(c, a, r, t), start = list(c = min(y) - 1, a = diff(range(y)), r = 0.3)))
  at <- function() curve(b["c"], b["a"], b["r"], t)
  for (i in 1:20) b <- b + qr.solve(attr(at(), "gradient"), y - at())
  rss <- sum((y - at())^2)
  list(value = b, rss = rss, error = sqrt(diag(solve(crossprod(attr(at(), "gradient")))) * rss / (length(y) - 3)))
}
masters <- function() glm(I(group == "master") ~ score, binomial, rows("contrast"), control = glm.control(epsilon = 1e-14, maxit = 100))
# glm's own errors come from the step before the last.
logistic_error <- function() {
  m <- masters(); p <- plogis(predict(m)); x <- model.matrix(m)
  sqrt(diag(solve(t(x) %*% (x * p * (1 - p)))))[2]
}
power_t <- function(n, d) { df <- 2 * n - 2; t <- qt(0.975, df); l <- d * sqrt(n / 2); pt(-t, df, l) + pt(t, df, l, lower.tail = FALSE) }
power_f <- function(n, f, k) pf(qf(0.95, k - 1, k * (n - 1)), k - 1, k * (n - 1), f^2 * k * n, lower.tail = FALSE)
solve_for <- function(f, from, to) uniroot(f, c(from, to), tol = 1e-13)$root
# Eqs. 25 to 27: class means with the weights of the classes, then the weights of the nine indices.
index_weights <- c(0.15, 0.15, 0.15, 0.15, 0.1, 0.1, 0.1, 0.05, 0.05)
class_weights <- c(A = 0.2, B = 0.3, C = 0.5)
m25 <- function(model, index) {
  d <- rows("marks"); d <- d[d$model == model & d$index == index, ]
  sum(class_weights * tapply(d$score, d$class, mean)[names(class_weights)])
}
s26 <- function(model, index) {
  d <- rows("marks"); d <- d[d$model == model & d$index == index, ]
  mean((d$score - m25(model, index))^2)
}
of_index <- function(model, index) { d <- rows("marks"); d[d$model == model & d$index == index, ] }
# Standard error of M from the spread within the classes, degrees of freedom by Welch and Satterthwaite.
se25 <- function(model, index) {
  d <- of_index(model, index); n <- tapply(d$score, d$class, length)[names(class_weights)]
  part <- class_weights^2 * tapply(d$score, d$class, var)[names(class_weights)] / n
  list(error = sqrt(sum(part)), df = sum(part)^2 / sum(part^2 / (n - 1)))
}
moment25 <- function(model, index) {
  d <- of_index(model, index)
  sum(class_weights * tapply((d$score - m25(model, index))^2, d$class, mean)[names(class_weights)])
}
# Incomplete marks: lme4's model, mark after ~ group + mean mark before + (1 | subject) + (1 | rater). lme4 stops some 1e-8 from
# the minimum and lmerTest differentiates numerically; Newton's steps on the restricted likelihood in full matrices settle both.
# settled() fails where its result is further than 1e-4 from theirs.
holed <- function(name) {
  d <- rows(name); d <- d[!is.na(d$score), ]; d$group <- factor(d$group, unique(rows(name)$group))
  before <- tapply(d$score[d$occasion == "before"], d$subject[d$occasion == "before"], mean)
  d <- d[d$occasion == "after" & d$subject %in% names(before), ]
  d$before <- as.vector(before[d$subject])
  d$before <- d$before - mean(d$before[!duplicated(d$subject)])
  d
}
settled <- function(name, formula = score ~ 0 + group + before + (1 | subject) + (1 | rater), d = holed(name)) {
  fit <- suppressMessages(lmerTest::lmer(formula, d))
  x <- model.matrix(fit); y <- d$score; v <- list(diag(length(y)), tcrossprod(model.matrix(~ 0 + subject, d)), tcrossprod(model.matrix(~ 0 + rater, d)))
  start <- as.data.frame(lme4::VarCorr(fit)); start <- start$vcov[match(c("Residual", "subject", "rater"), start$grp)]
  v <- v[start > 0]; s <- start[start > 0]
  parts <- function() {
    w <- solve(Reduce("+", Map("*", s, v))); c <- solve(t(x) %*% w %*% x); p <- w - w %*% x %*% c %*% t(x) %*% w
    pv <- lapply(v, function(one) p %*% one); py <- p %*% y
    list(w = w, c = c, slope = sapply(pv, function(one) sum(diag(one))) - sapply(v, function(one) sum(py * (one %*% py))),
         curvature = outer(seq_along(v), seq_along(v), Vectorize(function(i, j) 2 * sum(py * (v[[i]] %*% p %*% v[[j]] %*% py)) - sum(pv[[i]] * t(pv[[j]])))))
  }
  for (i in 1:8) { at <- parts(); s <- s - solve(at$curvature, at$slope) }
  at <- parts(); b <- as.vector(at$c %*% t(x) %*% at$w %*% y)
  slopes <- lapply(v, function(one) at$c %*% t(x) %*% at$w %*% one %*% at$w %*% x %*% at$c)
  variance <- numeric(3); variance[start > 0] <- s
  all <- summary(fit)$coefficients
  stopifnot(max(abs(b / all[, 1] - 1), abs(sqrt(diag(at$c)) / all[, 2] - 1), abs(sapply(seq_along(b), function(i) of_contrast(list(c = at$c, slopes = slopes, a = 2 * solve(at$curvature)), replace(0 * b, i, 1))$df) / all[, 3] - 1)) < 1e-4)
  list(b = b, c = at$c, slopes = slopes, a = 2 * solve(at$curvature), variance = variance, criterion = as.vector(lme4::REMLcrit(fit)))
}
of_contrast <- function(m, l) {
  variance <- sum(l * (m$c %*% l)); g <- sapply(m$slopes, function(one) sum(l * (one %*% l)))
  list(value = if (is.null(m$b)) NA else sum(l * m$b), error = sqrt(variance), df = 2 * variance^2 / sum(g * (m$a %*% g)))
}
mixed_model <- function(name, l) { r <- of_contrast(settled(name), l); r$t <- r$value / r$error; r$p <- 2 * pt(-abs(r$t), r$df); r$reach <- qt(0.975, r$df) * r$error; r }
# Fai and Cornelius' degrees of freedom, as lmerTest's anova() has them.
mixed_f <- function(name) {
  m <- settled(name); q <- length(m$b) - 2; l <- cbind(1, -diag(q), 0)
  e <- eigen(l %*% m$c %*% t(l)); nu <- apply(t(e$vectors) %*% l, 1, function(row) of_contrast(m, row)$df)
  f <- sum((t(e$vectors) %*% l %*% m$b)^2 / e$values) / q
  s <- sum(nu / (nu - 2)); df <- if (diff(range(nu)) < 1e-8) mean(nu) else 2 * s / (s - q)
  list(f = f, df = df, p = pf(f, q, df, lower.tail = FALSE))
}
reliability <- function(name) {
  d <- rows(name); d <- d[!is.na(d$score), ]; d$subject <- d$target
  m <- settled(name, score ~ 1 + (1 | subject) + (1 | rater), d); v <- m$variance; k <- as.numeric(names(which.max(table(table(d$target)))))
  list(single = v[2] / sum(v), mean = v[2] / (v[2] + (v[1] + v[3]) / k), variance = v, sem = sqrt(v[1] + v[3]))
}
# Complete cases: mean marks of subjects with one at both occasions.
complete_cases <- function(name) { d <- holed(name); a <- aggregate(score ~ subject + group + before, d, mean); a }
# Analysis of covariance of a table with two occasions; slopes of their own; where two groups differ (Johnson & Neyman 1936).
two_occasions <- function(name) {
  w <- reshape(rows(name), idvar = c("subject", "group"), timevar = "occasion", direction = "wide")
  names(w) <- sub("score.", "", names(w), fixed = TRUE); w$group <- factor(w$group, unique(w$group)); w
}
separate <- function(name) lm(after ~ 0 + group + group:before, two_occasions(name))
# Differences of the adjusted means with the errors of HC3 (car::hccm) and the degrees of freedom of Bell and McCaffrey
# (2002), all pairs in the order of the groups.
robust <- function(name) {
  w <- two_occasions(name); w$x <- w$before - mean(w$before)
  m <- lm(after ~ 0 + group + x, w); k <- nlevels(w$group); v <- car::hccm(m, type = "hc3")
  pairs <- t(combn(k, 2)); X <- model.matrix(m); B <- solve(crossprod(X), t(X)); M <- diag(nrow(X)) - X %*% B
  df <- apply(pairs, 1, function(i) {
    A <- diag((B[i[1], ] - B[i[2], ])^2 / diag(M)^2)
    sum(diag(A %*% M))^2 / sum(diag(A %*% M %*% A %*% M))
  })
  d <- coef(m)[pairs[, 1]] - coef(m)[pairs[, 2]]
  e <- apply(pairs, 1, function(i) sqrt(v[i[1], i[1]] + v[i[2], i[2]] - 2 * v[i[1], i[2]]))
  p <- 2 * pt(-abs(d / e), df); holm <- p.adjust(p, "holm")
  # The factor by which Holm's method multiplies p, at least that of its step (Ludbrook 2000).
  o <- order(p); step <- largest <- p; step[o] <- rev(seq_along(p)); largest[o] <- cummax(step[o] * p[o])
  factor <- pmax(step, largest / p)
  data.frame(difference = d, error = e, t = d / e, p = p, p_holm = holm, df = df, reach = qt(0.975, df) * e,
             holm_reach = qt(1 - 0.025 / factor, df) * e)
}
at_baseline <- function(name, a, b, deviations) {
  w <- two_occasions(name); m <- separate(name); k <- nlevels(w$group)
  x <- mean(w$before) + deviations * sd(w$before); l <- numeric(2 * k); l[c(a, b)] <- c(1, -1); l[k + c(a, b)] <- c(x, -x)
  e <- sqrt(sum(l * (vcov(m) %*% l))); d <- sum(l * coef(m))
  list(difference = d, error = e, t = d / e, p = 2 * pt(-abs(d / e), df.residual(m)), reach = qt(0.975, df.residual(m)) * e)
}
neyman <- function(name, a, b) {
  m <- separate(name); k <- nlevels(two_occasions(name)$group); v <- vcov(m); t2 <- qt(0.975, df.residual(m))^2
  l0 <- numeric(2 * k); l0[c(a, b)] <- c(1, -1); l1 <- numeric(2 * k); l1[k + c(a, b)] <- c(1, -1)
  q <- function(u, w) sum(u * coef(m)) * sum(w * coef(m)) - t2 * sum(u * (v %*% w))
  z <- c(q(l0, l0), 2 * q(l0, l1), q(l1, l1)); f <- function(x) z[1] + x * (z[2] + x * z[3])
  sort(sapply(Re(polyroot(z)), function(x) { for (i in 1:5) x <- x - f(x) / (z[2] + 2 * x * z[3]); x }))
}
tost <- function(d, e, df, margin) max(pt((d + margin) / e, df, lower.tail = FALSE), pt((d - margin) / e, df))
# Missing marks (of the usual five) are imputed as the lowest score in one group, the highest in the other.
bound <- function(name, a, b, usual, low, high) {
  d <- rows(name); d$group <- factor(d$group, unique(d$group)); g <- levels(d$group)
  one <- function(s) {
    x <- d$score[d$subject == s & d$occasion == "before" & !is.na(d$score)]; y <- d$score[d$subject == s & d$occasion == "after" & !is.na(d$score)]
    of <- as.character(d$group[d$subject == s][1]); fill <- if (of == g[a]) low else if (of == g[b]) high else NULL
    data.frame(group = of, before = mean(x), after = mean(c(y, rep(fill, usual - length(y)))))
  }
  w <- do.call(rbind, lapply(unique(d$subject), one)); w$before[is.nan(w$before)] <- mean(w$before, na.rm = TRUE)
  w <- w[!is.nan(w$after), ]; w$group <- factor(w$group, g)
  m <- lm(after ~ 0 + group + before, w); coef(m)[[a]] - coef(m)[[b]]
}
# Components of a fully crossed table of persons, raters and occasions, and of raters nested in tasks (Brennan 2001).
g_crossed <- function() {
  d <- rows("repeats"); s <- summary(aov(score ~ target * rater * occasion, d))[[1]]
  m <- setNames(s[, 3], trimws(rownames(s))); p <- 8; r <- 3; o <- 2; e <- m[["target:rater:occasion"]]
  v <- c(pr = (m[["target:rater"]] - e) / o, po = (m[["target:occasion"]] - e) / r, ro = (m[["rater:occasion"]] - e) / p, pro = e)
  c(p = (m[["target"]] - m[["target:rater"]] - m[["target:occasion"]] + e) / (r * o),
    r = (m[["rater"]] - m[["target:rater"]] - m[["rater:occasion"]] + e) / (p * o),
    o = (m[["occasion"]] - m[["target:occasion"]] - m[["rater:occasion"]] + e) / (p * r), v)
}
g_nested <- function() {
  d <- rows("stations"); s <- summary(aov(score ~ target * task + task:rater, d))[[1]]
  m <- setNames(s[, 3], trimws(rownames(s))); p <- 8; t <- 3; r <- 2; e <- m[["Residuals"]]
  c(p = (m[["target"]] - m[["target:task"]]) / (t * r), t = (m[["task"]] - m[["target:task"]] - m[["task:rater"]] + e) / (p * r),
    rt = (m[["task:rater"]] - e) / p, pt = (m[["target:task"]] - e) / r, prt = e)
}
# Every resample of the subjects; bias-corrected and accelerated (Efron 1987), quantiles of type 1, ties in z0 by halves.
bootstrapped <- function() {
  x <- rows("gains")$score; n <- length(x); estimate <- mean(x)
  all <- rowMeans(matrix(x[as.matrix(expand.grid(rep(list(1:n), n)))], ncol = n))
  z0 <- qnorm(mean((all < estimate - 1e-12) + 0.5 * (abs(all - estimate) <= 1e-12)))
  left <- sapply(1:n, function(i) mean(x[-i])); d <- mean(left) - left; a <- sum(d^3) / (6 * sum(d^2)^1.5)
  level <- function(z) pnorm(z0 + (z0 + z) / (1 - a * (z0 + z)))
  list(error = sqrt(mean((all - mean(all))^2)), z0 = z0, acceleration = a,
       percentile = quantile(all, c(0.025, 0.975), type = 1, names = FALSE),
       bca = quantile(all, level(qnorm(c(0.025, 0.975))), type = 1, names = FALSE))
}
# Probability that the LC-CUSUM (Biau & Porcher 2010) reaches its limit, by enumeration of all sums.
lc_pass <- function(failure, attempts, adequate, inadequate, limit) {
  up <- log((1 - adequate) / (1 - inadequate)); down <- log(adequate / inadequate)
  p <- c("0" = 1); passed <- 0
  for (i in 1:attempts) {
    s <- as.numeric(names(p)); to <- c(pmax(0, s + up), pmax(0, s + down)); q <- c(p * (1 - failure), p * failure)
    there <- to >= limit; passed <- passed + sum(q[there])
    p <- tapply(q[!there], sprintf("%.12f", to[!there]), sum); p <- setNames(as.vector(p), names(p))
  }
  passed
}
# Probability of not counting as competent after so many attempts: the same, then the reversed sum, whose limit leads
# back to the start.
lc_not_able <- function(failure, attempts, adequate, inadequate, limit) {
  up <- log((1 - adequate) / (1 - inadequate)); down <- log(adequate / inadequate)
  moved <- function(p, rise, fall, chance) {
    s <- as.numeric(names(p)); to <- c(pmax(0, s + rise), pmax(0, s + fall)); q <- c(p * chance, p * (1 - chance))
    there <- to >= limit; kept <- tapply(q[!there], sprintf("%.12f", to[!there]), sum)
    list(p = setNames(as.vector(kept), names(kept)), reached = sum(q[there]))
  }
  entered <- function(p, share) { zero <- sprintf("%.12f", 0); p[zero] <- share + if (zero %in% names(p)) p[[zero]] else 0; p }
  learning <- c("0.000000000000" = 1); watch <- c("0.000000000000" = 0)
  for (i in 1:attempts) {
    l <- moved(learning, up, down, 1 - failure); w <- moved(watch, -down, -up, failure)
    learning <- entered(l$p, w$reached); watch <- entered(w$p, l$reached)
  }
  sum(learning)
}
# Average run length in control: the integral equation by Gauss and Legendre (Crowder 1987); both sides together.
run_length <- function(limit, k = 0.5, nodes = 80) {
  i <- 1:(nodes - 1); b <- i / sqrt(4 * i^2 - 1); j <- matrix(0, nodes, nodes); j[cbind(i, i + 1)] <- b; j[cbind(i + 1, i)] <- b
  e <- eigen(j, symmetric = TRUE); x <- limit * (e$values + 1) / 2; w <- limit * e$vectors[1, ]^2
  at <- c(0, x); m <- outer(at, x, function(z, y) dnorm(y + k - z)) * rep(w, each = nodes + 1)
  solve(diag(nodes + 1) - cbind(pnorm(k - at), m), rep(1, nodes + 1))[1] / 2
}
# Many-facet Rasch by joint maximum likelihood is a Poisson log-linear model with a level of its own for each mark.
rasch <- function(name) {
  d <- rows(name); d <- d[!is.na(d$score), ]; low <- min(d$score); high <- max(d$score)
  extreme <- names(which(tapply(d$score, d$target, function(v) all(v == low) || all(v == high)))); d <- d[!d$target %in% extreme, ]
  k <- high - low; long <- d[rep(seq_len(nrow(d)), each = k + 1), ]
  long$mark <- factor(rep(seq_len(nrow(d)), each = k + 1)); long$step <- rep(0:k, nrow(d)); long$y <- as.numeric(long$score - low == long$step)
  person <- model.matrix(~ 0 + target, long); rater <- model.matrix(~ C(factor(rater), contr.sum), long)[, -1]
  x <- cbind(model.matrix(~ 0 + mark, long), person * long$step, rater * long$step, sapply(1:(k - 1), function(c) as.numeric(long$step == c)))
  b <- suppressWarnings(glm.fit(x, long$y, family = poisson(), control = glm.control(epsilon = 1e-15, maxit = 200)))$coefficients
  at <- nlevels(long$mark) + ncol(person); severity <- -b[at + seq_len(ncol(rater))]
  unname(c(severity, -sum(severity)))
}
