/** Options, console and the thread of the cells program. */
package simgsm.cells.app;
