package simgsm.cells.snapshot;

/**
 * A tower and its cell.
 *
 * @param name of the tower
 * @param area its current location area code
 * @param isOn true if it transmits
 * @param isConnected true if the controller is connected
 * @param refusal why the controller refuses the tower; else empty
 * @param powerDbm current radiated power
 * @param freeChannels unused traffic channels
 * @param channels all traffic channels
 */
public record CellState(
        String name,
        int area,
        boolean isOn,
        boolean isConnected,
        String refusal,
        double powerDbm,
        int freeChannels,
        int channels) {}
