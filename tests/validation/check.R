# SPDX-License-Identifier: GPL-3.0-or-later
# Evaluates the R command of each line of cases.tsv and compares the result with the stored value, to 1e-9 relative.
# `Rscript check.R --write` stores R's values.
arguments <- commandArgs(FALSE)
folder <- dirname(normalizePath(sub("^--file=", "", grep("^--file=", arguments, value = TRUE))))
source(file.path(folder, "statistics.R"))
file <- file.path(folder, "cases.tsv")
cases <- read.delim(file, quote = "", colClasses = "character", na.strings = character(0))
found <- vapply(seq_len(nrow(cases)), function(i) {
  tryCatch({
             invisible(capture.output(  # some packages talk while they compute
               value <- as.numeric(suppressMessages(suppressWarnings(eval(parse(text = cases$r[i])))))))
             value
           },
           error = function(e) { message(cases$r[i], ": ", conditionMessage(e)); NaN })
}, 0)
if ("--write" %in% arguments) {
  cases$value <- sprintf("%.15g", found)
  write.table(cases, file, sep = "\t", quote = FALSE, row.names = FALSE)
}
stored <- as.numeric(cases$value)
wrong <- !is.finite(found) | abs(found - stored) > 1e-9 * abs(found) + 1e-14
for (i in which(wrong)) message(cases$statistic[i], ": R says ", format(found[i], digits = 15), ", the table ", cases$value[i], " (", cases$r[i], ")")
cat(sum(!wrong), "values as R", as.character(getRversion()), "gives them,", sum(wrong), "others\n")
quit(status = as.integer(any(wrong)))
