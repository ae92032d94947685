/** The thread that owns the cells and their sockets. Read {@link simgsm.cells.net.CellsLoop}. */
package simgsm.cells.net;
