package simgsm.center.msc.call;

import java.util.EnumMap;
import java.util.Map;
import simgsm.abis.RtpPacket;
import simgsm.air.ProtocolViolation;
import simgsm.dtmf.DtmfDigit;
import simgsm.dtmf.DtmfListener;
import simgsm.dtmf.DtmfReceiver;
import simgsm.speech.SpeechCodec;

/**
 * Decodes the keys in the speech of the latest call, for the operator's window: the caller's keys plain, the called
 * party's in brackets, as {@code **#**20** [6] [3]}. Idle until {@link #watch}.
 */
public final class KeyTap {
    /** Maximum length of the text; the oldest characters are removed. */
    private static final int MAX_LENGTH = 80;

    private final StringBuilder keys = new StringBuilder();
    private boolean isWatched;
    private boolean calledSpokeLast;
    private NetworkCall call;
    private LegReceiver caller;
    private LegReceiver called;

    /** Decodes keys from now on. */
    public void watch() {
        isWatched = true;
    }

    /** Decodes this call from now on, and clears the text of the last one. */
    public void follow(NetworkCall newCall) {
        if (newCall != call) {
            call = newCall;
            keys.setLength(0);
            calledSpokeLast = false;
            caller = new LegReceiver(digit -> heard(digit, false));
            called = new LegReceiver(digit -> heard(digit, true));
        }
    }

    /** Decodes a speech frame of a leg. */
    void passed(CallLeg leg, byte[] rtp) {
        if (!isWatched || call == null) {
            return;
        }
        if (leg == call.originating()) {
            caller.accept(rtp);
        } else if (leg == call.terminating()) {
            called.accept(rtp);
        }
    }

    /** The keys of the followed call. */
    public String keys() {
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

    /** The DTMF receiver of one leg. */
    private static final class LegReceiver {
        private final DtmfReceiver receiver;
        private final Map<SpeechCodec.Kind, SpeechCodec> codecs = new EnumMap<>(SpeechCodec.Kind.class);

        LegReceiver(DtmfListener listener) {
            receiver = new DtmfReceiver(listener);
        }

        /** Decodes a frame; an invalid one ends the current digit. */
        void accept(byte[] rtp) {
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
