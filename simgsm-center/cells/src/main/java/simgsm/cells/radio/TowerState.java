package simgsm.cells.radio;

/**
 * A tower's variable properties.
 *
 * @param powerDbm radiated power, antenna gain included
 */
public record TowerState(boolean isOn, double powerDbm) {}
