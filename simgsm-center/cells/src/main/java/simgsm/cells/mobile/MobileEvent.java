package simgsm.cells.mobile;

import java.util.List;
import simgsm.air.CipherAlgorithm;
import simgsm.cells.snapshot.PassingStep;
import simgsm.cells.town.TownPlace;
import simgsm.event.EventLine;

/** An event of a mobile. */
public sealed interface MobileEvent {
    /** The mobile's number, or its address while that is unknown. */
    Mobile mobile();

    /** A mobile has selected a cell; C2 in dB. */
    @EventLine("camped number=mobile.number cell= c2=:0")
    record Camped(Mobile mobile, String cell, double c2) implements MobileEvent {}

    /** No cell is suitable any more. */
    record CellLost(Mobile mobile, String cell) implements MobileEvent {}

    /** The network has accepted the location. */
    @EventLine("location-update number=mobile.number lac=area")
    record LocationUpdated(Mobile mobile, int area) implements MobileEvent {}

    /** The level of a cell at the mobile. @param rxlev TS 45.008, 8.1.4 */
    record CellLevel(String cell, int rxlev) {
        @Override
        public String toString() {
            return cell + ":" + rxlev;
        }
    }

    /**
     * With {@code reports on}: each measurement report, levels as {@code name:rxlev}.
     *
     * @param number of the report, from 0
     * @param quality RXQUAL, TS 45.008, 8.2.4
     * @param timingAdvance bit periods, 0 to 63
     */
    @EventLine("report number=mobile.number nr=number serving= neighbours=")
    record Reported(
            Mobile mobile, int number, CellLevel serving, List<CellLevel> neighbours, int quality, int timingAdvance)
            implements MobileEvent {}

    /** The end of a handover. */
    enum HandoverResult {
        SUCCESS,
        FAILURE
    }

    /** A handover has ended: success or failure. @param cause RR cause of HANDOVER FAILURE; 0 for a success */
    @EventLine("handover number=mobile.number from= to= result= cause=")
    record HandedOver(Mobile mobile, String from, String to, HandoverResult result, int cause) implements MobileEvent {}

    /** Silence during a handover. */
    @EventLine("speech-gap number=mobile.number millis=")
    record SpeechGap(Mobile mobile, int millis) implements MobileEvent {}

    /** The mobile has begun to cipher with {@code a5/1} or {@code a5/3}, or has ended it: {@code a5/0}. */
    @EventLine("cipher number=mobile.number algorithm=algorithm.title")
    record Ciphered(Mobile mobile, CipherAlgorithm algorithm) implements MobileEvent {}

    /** The tower cannot read the mobile, whose card has another key; the channel will fail. */
    @EventLine("cipher-mismatch number=mobile.number algorithm=algorithm.title")
    record CipherMismatched(Mobile mobile, CipherAlgorithm algorithm) implements MobileEvent {}

    /** The channel is lost. */
    @EventLine("radio-link-failure number=mobile.number")
    record RadioLinkFailed(Mobile mobile) implements MobileEvent {}

    /** The window's user has moved a mobile. */
    @EventLine("placed number=mobile.number x=place.xMetres:1 y=place.yMetres:1")
    record MobilePlaced(Mobile mobile, TownPlace place) implements MobileEvent {}

    /** One step of signalling, for the window. @param to the new cell of a handover, else empty */
    record Passed(Mobile mobile, PassingStep.Kind step, String from, String to, int figure) implements MobileEvent {}
}
