package simgsm.modem;

import simgsm.dtmf.DtmfDigit;
import simgsm.dtmf.DtmfKey;
import simgsm.station.context.StationEvent;
import simgsm.words.WordComparison;

/** Events of a modem besides its station's. */
public sealed interface ModemEvent extends StationEvent.OfTerminal {
    /** A key in an accepted call, at its decision, while its tone sounds. */
    record KeyDecided(DtmfDigit digit) implements ModemEvent {}

    /** The last decided key has ended; a real modem without durations reports it at once. */
    record KeyEnded() implements ModemEvent {}

    /** A tone could not be sent. */
    record ReplyToneFailed(DtmfKey key) implements ModemEvent {}

    /** An accepted call had no key for 60 s; the modem clears it, and its release follows. */
    record CallIdle(int seconds) implements ModemEvent {}

    /**
     * A key in an accepted call may have been lost with the speech, or its report could not be read; an order with it
     * cannot be trusted.
     */
    record KeyUnreadable() implements ModemEvent {}

    /** All keys in this much speech of an accepted call, lost frames included, have been reported. */
    record SpeechProcessed(int samples) implements ModemEvent {}

    /** A real modem's state has changed. @param text the answer that shows it, or the network's name */
    record StateChanged(ModemState state, String text) implements ModemEvent {}

    /** The first word of a reply is being said. @param text all its words */
    record WordsBegun(String text) implements ModemEvent {}

    /** The ear has compared a word of the caller. */
    record WordHeard(WordComparison compared) implements ModemEvent {}

    /** The caller has confirmed an order by voice. @param keys that give the same order */
    record OrderSpoken(String keys) implements ModemEvent {}

    /** A tone of {@link Modem#sendTone} or of the {@link CallDecision} has been sent completely. */
    record ReplyToneSent(DtmfKey key) implements ModemEvent {}
}
