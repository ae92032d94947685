/** Content and actions of the cells program's window: immutable snapshots, and requests. Needs no display. */
package simgsm.cells.snapshot;
