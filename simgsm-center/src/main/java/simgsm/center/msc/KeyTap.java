package simgsm.center.msc;

import java.util.EnumMap;
import java.util.Map;
import simgsm.abis.RtpPacket;
import simgsm.air.ProtocolViolation;
import simgsm.dtmf.DtmfDigit;
import simgsm.dtmf.DtmfListener;
import simgsm.dtmf.DtmfReceiver;
import simgsm.speech.SpeechCodec;

/**
 * Hears the keys in the speech of the call that began last, for the operator's window: the caller's as they are, the
 * called side's in brackets, as {@code **#**20** [6] [3]}. Costs nothing until somebody watches.
 */
final class KeyTap {
    /** Of the text; what came first is forgotten first. */
    private static final int MAX_LENGTH = 80;

    private final StringBuilder keys = new StringBuilder();
    private boolean isWatched;
    private boolean calledSpokeLast;
    private NetworkCall call;
    private Ear caller;
    private Ear called;

    /** From now on keys are heard. */
    void watch() {
        isWatched = true;
    }

    /** Turns to this call and forgets the one before. */
    void follow(NetworkCall newCall) {
        if (newCall != call) {
            call = newCall;
            keys.setLength(0);
            calledSpokeLast = false;
            caller = new Ear(digit -> heard(digit, false));
            called = new Ear(digit -> heard(digit, true));
        }
    }

    /** Speech of one leg of some call has passed. */
    void passed(CallLeg leg, byte[] rtp) {
        if (!isWatched || call == null) {
            return;
        }
        if (leg == call.originating()) {
            caller.hear(rtp);
        } else if (leg == call.terminating()) {
            called.hear(rtp);
        }
    }

    /** The keys of the call that is followed. */
    String keys() {
        return keys.toString();
    }

    private void heard(DtmfDigit digit, boolean isCalled) {
        if (keys.length() > 0 && (isCalled || calledSpokeLast)) {
            keys.append(' ');
        }
        char symbol = digit.key().symbol();
        keys.append(isCalled ? "[" + symbol + "]" : String.valueOf(symbol));
        calledSpokeLast = isCalled;
        keys.delete(0, Math.max(0, keys.length() - MAX_LENGTH));
    }

    /** One side of the call. */
    private static final class Ear {
        private final DtmfReceiver receiver;
        private final Map<SpeechCodec.Kind, SpeechCodec> codecs = new EnumMap<>(SpeechCodec.Kind.class);

        Ear(DtmfListener listener) {
            receiver = new DtmfReceiver(listener);
        }

        /** Frames that are not what they claim are for the far end to judge; here they are passed over. */
        void hear(byte[] rtp) {
            try {
                RtpPacket packet = RtpPacket.decode(rtp);
                SpeechCodec.Kind kind = packet.payloadType() == RtpPacket.A_LAW
                        ? SpeechCodec.Kind.A_LAW
                        : SpeechCodec.Kind.GSM_FULL_RATE;
                receiver.accept(
                        codecs.computeIfAbsent(kind, SpeechCodec.Kind::open).decode(packet.payload()));
            } catch (ProtocolViolation | IllegalArgumentException broken) {
                receiver.finish();
            }
        }
    }
}
