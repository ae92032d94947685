/** The window of the cells program: the map, the mobile, the towers and what passes. Begin with {@link TownPanel}. */
package simgsm.cells.ui;
