package simgsm.cells.tower;

import simgsm.event.EventLine;

/** The controller refuses a tower, which tries again. @param text the reason, in the controller's words if it tells one */
@EventLine("cell-refused name= text=")
public record TowerRefused(String name, String text) {}
