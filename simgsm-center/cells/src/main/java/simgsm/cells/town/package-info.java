/** The town: towers, places, and the file that lists them. Read {@link simgsm.cells.town.Town}. */
package simgsm.cells.town;
