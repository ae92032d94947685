package simgsm.phone.handset;

import java.util.Optional;
import simgsm.air.Cause;
import simgsm.dtmf.DtmfKey;
import simgsm.event.EventLine;
import simgsm.station.context.StationEvent;

/** Events of a handset besides its station's. */
public sealed interface HandsetEvent extends StationEvent.OfTerminal {
    /** The last tone of a {@code press} has been sent. @param keys as pressed, without blanks */
    @EventLine("sent keys=")
    record KeysSent(String keys) implements HandsetEvent {}

    /** The network refuses signalled keys. @param keys those not sent */
    record KeysNotSent(String keys, Cause cause) implements HandsetEvent {}

    /** The equipment's identity, requested by {@code *#06#}. @param imei 15 digits */
    @EventLine("imei number=imei")
    record ImeiShown(String imei) implements HandsetEvent {}

    /** A sentence of a robot's prompts is recognised in the far end's speech, 300 ms after its end. */
    @EventLine("words text=")
    record WordsHeard(String text) implements HandsetEvent {}

    /** The last sample of a {@code play} has been sent. */
    @EventLine("played millis=")
    record SoundPlayed(int millis) implements HandsetEvent {}

    /**
     * A tone is decoded and still sounds.
     *
     * @param meaning text key of its meaning as a robot's reply
     */
    @EventLine("tone key=key.symbol meaning=")
    record ToneHeard(DtmfKey key, Optional<String> meaning) implements HandsetEvent {
        /** With the meaning of a robot's reply. */
        public ToneHeard(DtmfKey key) {
            this(key, ToneMeaning.textKey(key));
        }
    }
}
