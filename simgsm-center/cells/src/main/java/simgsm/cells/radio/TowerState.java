package simgsm.cells.radio;

/**
 * What can be changed at a tower while the town runs.
 *
 * @param powerDbm radiated power, antenna gain included
 */
public record TowerState(boolean isOn, double powerDbm) {}
