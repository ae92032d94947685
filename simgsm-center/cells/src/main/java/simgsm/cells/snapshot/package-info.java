/** What the cells program shows: immutable snapshots, and what a window may ask it to do. Needs no display. */
package simgsm.cells.snapshot;
