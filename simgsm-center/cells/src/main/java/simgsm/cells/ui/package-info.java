/**
 * The window of the cells program: the map, the mobile, the towers and the signalling. Begin with {@link TownPanel}.
 */
package simgsm.cells.ui;
