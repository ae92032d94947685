package simgsm.center.msc;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import simgsm.air.Direction;
import simgsm.air.MobilityManagement;
import simgsm.air.Msisdn;
import simgsm.air.ProtocolViolation;
import simgsm.air.RelayMessage;
import simgsm.air.ShortMessageControl;
import simgsm.air.TransactionIdentifier;
import simgsm.center.smsc.MessageState;
import simgsm.octets.OctetString;
import simgsm.sms.DeliverTpdu;
import simgsm.sms.SmsAddress;
import simgsm.sms.SubmitTpdu;
import simgsm.sms.Tpdu;
import simgsm.sms.TpduCodec;
import simgsm.sms.UserData;
import simgsm.sms.ValidityPeriod;

/** Mobiles that send and get short messages through an exchange. */
abstract class MessageStage {
    static final TransactionIdentifier FIRST = new TransactionIdentifier(0, false);

    final TestNetwork network = new TestNetwork();

    static OctetString submit(String to, String text, boolean wantsReport, Optional<ValidityPeriod> validity) {
        return TpduCodec.encode(new SubmitTpdu(
                false, wantsReport, false, 7, SmsAddress.of(new Msisdn(to)), 0, validity, UserData.of(text)));
    }

    static OctetString submit(String to, String text) {
        return submit(to, text, false, Optional.empty());
    }

    /** Sends a message, from CM SERVICE REQUEST to the released channel. */
    static void send(TestMobile sender, OctetString tpdu) {
        sender.requestService(MobilityManagement.ServiceType.SHORT_MESSAGE);
        sender.sendMessage(0, 9, tpdu);
        sender.next(ShortMessageControl.CpAck.class);
        ShortMessageControl.CpData data = sender.next(ShortMessageControl.CpData.class);
        assertEquals(new RelayMessage.RpAck(9, Optional.empty()), data.relay());
        assertEquals(FIRST.answered(), data.transaction());
        sender.tell(new ShortMessageControl.CpAck(FIRST));
        sender.leaveReleasedChannel();
    }

    static Tpdu decode(OctetString tpdu) {
        try {
            return TpduCodec.decode(tpdu, Direction.DOWNLINK);
        } catch (ProtocolViolation violation) {
            throw new AssertionError(violation);
        }
    }

    static String textOf(OctetString tpdu) {
        return ((DeliverTpdu) decode(tpdu)).userData().text();
    }

    List<MessageState> states() {
        return network.events.stream()
                .filter(ExchangeEvent.MessageChanged.class::isInstance)
                .map(event -> ((ExchangeEvent.MessageChanged) event).state())
                .toList();
    }
}
