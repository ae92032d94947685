package simgsm.cells.snapshot;

/**
 * A tower and its cell.
 *
 * @param name of the tower
 * @param area the location area code that it broadcasts now
 * @param isOn whether it transmits
 * @param isConnected whether the controller has it
 * @param powerDbm radiated power now
 * @param freeChannels traffic channels that are not in use
 * @param channels all traffic channels
 */
public record CellState(
        String name, int area, boolean isOn, boolean isConnected, double powerDbm, int freeChannels, int channels) {}
