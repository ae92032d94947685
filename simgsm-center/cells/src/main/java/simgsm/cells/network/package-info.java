/** All towers and mobiles of the town as one core. Read {@link simgsm.cells.network.CellNetwork}. */
package simgsm.cells.network;
