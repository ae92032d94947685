package blackbox.fuzz;

import java.util.Locale;
import simgsm.abis.RslMessage;
import simgsm.air.CallControl;
import simgsm.air.Direction;
import simgsm.air.Layer3Codec;
import simgsm.air.Layer3Message;
import simgsm.air.ProtocolViolation;
import simgsm.air.RelayMessage;
import simgsm.air.ShortMessageControl;
import simgsm.air.answer.ProtocolErrorAnswers;
import simgsm.octets.OctetString;
import simgsm.sms.BroadcastCollector;
import simgsm.sms.CellBroadcastPage;
import simgsm.sms.DeliverTpdu;
import simgsm.sms.Reassembler;
import simgsm.sms.Tpdu;
import simgsm.sms.TpduCodec;
import simgsm.trace.MessageText;

/** Decodes an RSL message down to the text of a short message and encodes it again. */
final class SignallingRoundTrip {
    private static final int ACTIVE_CALL = 10;
    private static final long NANOS_PER_MESSAGE = 1_000_000;

    private final Reassembler reassembler = new Reassembler();
    private final BroadcastCollector broadcasts = new BroadcastCollector();
    private long nowNanos;

    /** @throws IllegalStateException if a message is not the same after encoding and decoding */
    void check(byte[] payload, Direction direction) throws ProtocolViolation {
        RslMessage message = RslMessage.decode(payload);
        requireSame(message, RslMessage.decode(message.encode()));
        MessageText.ofRsl(OctetString.of(payload), Locale.ROOT).fields().forEach(Object::toString);
        if (message instanceof RslMessage.EstablishIndication establish) {
            layer3(establish.layer3(), direction);
        } else if (message instanceof RslMessage.DataIndication data) {
            layer3(data.layer3(), direction);
        } else if (message instanceof RslMessage.DataRequest data) {
            layer3(data.layer3(), direction);
        } else if (message instanceof RslMessage.SmsBroadcastCommand broadcast) {
            CellBroadcastPage page = CellBroadcastPage.decode(broadcast.page());
            page.encode();
            broadcasts.accept(page);
        }
    }

    private void layer3(OctetString octets, Direction direction) throws ProtocolViolation {
        Layer3Message message;
        try {
            message = Layer3Codec.decode(octets.toArray(), direction);
        } catch (ProtocolViolation violation) {
            for (Layer3Message answer : ProtocolErrorAnswers.to(violation, ACTIVE_CALL)) {
                Layer3Codec.encode(answer, other(direction), 0);
            }
            throw violation;
        }
        if (!hasNoCalledNumber(message, direction)) {
            requireSame(message, Layer3Codec.decode(Layer3Codec.encode(message, direction, 0), direction));
        }
        if (message instanceof ShortMessageControl.CpData data && data.relay() instanceof RelayMessage.RpData relay) {
            transferUnit(TpduCodec.decode(relay.tpdu(), direction));
        }
    }

    private void transferUnit(Tpdu tpdu) {
        TpduCodec.encode(tpdu);
        if (tpdu instanceof DeliverTpdu deliver) {
            nowNanos += NANOS_PER_MESSAGE;
            reassembler.accept(deliver.originator(), deliver.userData(), nowNanos);
        }
    }

    private static Direction other(Direction direction) {
        return direction == Direction.UPLINK ? Direction.DOWNLINK : Direction.UPLINK;
    }

    /** A SETUP with an unreadable called number: the codec reads it but does not write it. */
    private static boolean hasNoCalledNumber(Layer3Message message, Direction direction) {
        return direction == Direction.UPLINK
                && message instanceof CallControl.Setup setup
                && setup.called().isEmpty();
    }

    private static void requireSame(Object read, Object again) {
        if (!read.equals(again)) {
            throw new IllegalStateException("decoded " + read + ", encoded and decoded " + again);
        }
    }
}
