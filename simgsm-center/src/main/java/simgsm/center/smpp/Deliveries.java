package simgsm.center.smpp;

import java.util.List;
import simgsm.center.smsc.Envelope;
import simgsm.center.smsc.EsmeOrigin;
import simgsm.center.smsc.ShortMessage;
import simgsm.sms.SmsAddress;

/** What waits in the centre, as deliver_sm has it. */
final class Deliveries {
    private static final int A_MOBILE = -1;

    private Deliveries() {}

    static SmppMessage of(Envelope envelope) {
        return envelope instanceof Envelope.Report report ? Receipts.of(report) : of(envelope.message());
    }

    private static SmppMessage of(ShortMessage message) {
        MessageContent.Translated content = MessageContent.translate(
                message.userData(), message.esme().map(EsmeOrigin::dataCoding).orElse(A_MOBILE));
        return SmppMessage.of(
                SmppAddress.of(message.sender()),
                SmppAddress.of(SmsAddress.of(message.to())),
                content.hasHeader() ? SmppMessage.HAS_HEADER : 0,
                0,
                content.dataCoding(),
                content.octets(),
                List.of(Tlv.ofTwoOctets(Tlv.USER_MESSAGE_REFERENCE, (int) (message.id() & 0xffff))));
    }
}
