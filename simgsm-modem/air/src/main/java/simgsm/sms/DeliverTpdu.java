package simgsm.sms;

import simgsm.octets.Bounds;
import simgsm.octets.Timestamp;

/**
 * SMS-DELIVER, from the centre to a mobile.
 *
 * @param moreMessages TP-MMS, inverted on the air: further messages wait in the centre
 * @param statusReportIndication TP-SRI: the sender receives a report
 * @param replyPath TP-RP
 * @param protocolIdentifier TP-PID, 0 for plain messages
 * @param timestamp TP-SCTS, time of acceptance by the centre
 */
public record DeliverTpdu(
        boolean moreMessages,
        boolean statusReportIndication,
        boolean replyPath,
        SmsAddress originator,
        int protocolIdentifier,
        Timestamp timestamp,
        UserData userData)
        implements Tpdu {
    public DeliverTpdu {
        Bounds.checkOctet("TP-PID", protocolIdentifier);
    }
}
