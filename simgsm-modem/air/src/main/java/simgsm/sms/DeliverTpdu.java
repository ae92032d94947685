package simgsm.sms;

/**
 * SMS-DELIVER, from the centre to a mobile.
 *
 * @param moreMessages further messages wait in the centre; on the air the bit is inverted (TP-MMS)
 * @param statusReportIndication TP-SRI: the sender will get a report
 * @param replyPath TP-RP
 * @param protocolIdentifier TP-PID, 0 for plain messages
 * @param timestamp TP-SCTS, when the centre took the message
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
        TpduCodec.checkOctet("TP-PID", protocolIdentifier);
    }
}
