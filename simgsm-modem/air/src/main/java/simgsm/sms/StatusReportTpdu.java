package simgsm.sms;

import simgsm.octets.Bounds;
import simgsm.octets.Timestamp;

/**
 * SMS-STATUS-REPORT, from the centre to the mobile that sent a message.
 *
 * @param moreMessages TP-MMS, inverted on the air: further messages wait in the centre
 * @param reference TP-MR of the message reported on
 * @param timestamp TP-SCTS, time of acceptance of that message by the centre
 * @param discharged TP-DT, time of delivery or of the last attempt
 * @param status TP-ST, see {@link DeliveryStatus}
 */
public record StatusReportTpdu(
        boolean moreMessages,
        int reference,
        SmsAddress recipient,
        Timestamp timestamp,
        Timestamp discharged,
        int status)
        implements Tpdu {
    public StatusReportTpdu {
        Bounds.checkOctet("TP-MR", reference);
        Bounds.checkOctet("TP-ST", status);
    }
}
