package simgsm.center.ui;

import java.util.function.Function;

/**
 * A column of a table.
 *
 * @param width its share of the width
 * @param value what a cell shows: text, or a {@link StateWord}
 */
record Column<T>(String title, int width, Function<T, Object> value) {}
