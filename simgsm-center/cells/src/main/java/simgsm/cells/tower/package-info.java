/**
 * A tower as its controller sees it: system information, channels, paging, and the RSL dialogue. Read {@link
 * simgsm.cells.tower.BaseStation} first.
 */
package simgsm.cells.tower;
