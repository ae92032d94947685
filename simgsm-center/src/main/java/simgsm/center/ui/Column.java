package simgsm.center.ui;

import java.util.function.Function;

/**
 * A column of a table.
 *
 * @param width in units; the first two columns keep theirs, the others share the rest
 * @param value content of a cell: text, or a {@link StateWord}
 */
record Column<T>(String title, int width, Function<T, Object> value) {}
