package simgsm.station;

import java.util.Optional;
import simgsm.air.Msisdn;
import simgsm.air.RejectCause;
import simgsm.sim.PinLock;
import simgsm.speech.SpeechCodec;
import simgsm.station.call.MobileCallTable.MobileCallState;

/**
 * The state of a station, immutable.
 *
 * @param linkUp true with a connection to the centre
 * @param rejectCause cause of a refused registration
 * @param cardRefused true if the SIM failed authentication
 * @param networkName the operator's name for the display, empty until the network sends it
 * @param peer the other party of the current call, if its number is known
 * @param codec of the speech sent; empty if a real modem does not name it
 * @param heardCodec of the newest speech frame received in the current call
 * @param card what the SIM demands of its user
 * @param cell serving the station through a cells program; empty in its own small cell
 */
public record StationSnapshot(
        boolean powered,
        boolean linkUp,
        boolean registered,
        Optional<RejectCause> rejectCause,
        boolean cardRefused,
        String networkName,
        MobileCallState callState,
        Optional<Msisdn> peer,
        Optional<SpeechCodec.Kind> codec,
        Optional<SpeechCodec.Kind> heardCodec,
        Optional<ServingCell> cell,
        PinLock.Status card) {
    /** True if only emergency calls are possible, because the SIM is locked, or one is under way without registration. */
    public boolean isEmergencyOnly() {
        boolean isLocked = !card.isReady();
        return linkUp
                && !registered
                && (isLocked || peer.filter(Msisdn::isEmergency).isPresent());
    }

    /** The bars of a display; all of them in the station's own small cell. */
    public int signalBars(int most) {
        return registered ? cell.map(serving -> serving.bars(most)).orElse(most) : 0;
    }
}
