package simgsm.cells.mobile;

import java.util.List;
import java.util.OptionalInt;
import simgsm.cells.snapshot.PassingStep;

/** What happens to a mobile. */
public sealed interface MobileEvent {
    /** Its number, or before that is known its address. */
    Mobile mobile();

    /** Chose a cell. */
    record Camped(Mobile mobile, String cell, double c2) implements MobileEvent {}

    /** No cell is good enough any more. */
    record CellLost(Mobile mobile, String cell) implements MobileEvent {}

    /** The network has accepted a location update in this area. */
    record LocationUpdated(Mobile mobile, int area) implements MobileEvent {}

    /** @param level RXLEV */
    record NeighbourLevel(String cell, int level) {}

    /** Sent a MEASUREMENT REPORT. @param level RXLEV of the serving cell */
    record Reported(Mobile mobile, int number, String cell, int level, List<NeighbourLevel> neighbours)
            implements MobileEvent {}

    /** A handover has ended. @param cause RR cause of HANDOVER FAILURE; empty for a success */
    record HandedOver(Mobile mobile, String from, String to, OptionalInt cause) implements MobileEvent {}

    /** The terminal received no speech for this time across a handover. */
    record SpeechGap(Mobile mobile, int millis) implements MobileEvent {}

    record RadioLinkFailed(Mobile mobile) implements MobileEvent {}

    /** One step of signalling, for the window. @param to the new cell of a handover, else empty */
    record Passed(Mobile mobile, PassingStep.Kind step, String from, String to, int figure) implements MobileEvent {}
}
