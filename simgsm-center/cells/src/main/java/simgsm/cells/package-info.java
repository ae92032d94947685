/** The main of simgsm-cells.jar. */
package simgsm.cells;
