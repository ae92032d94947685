package simgsm.sms;

/**
 * SMS-STATUS-REPORT, from the centre to the mobile that sent a message.
 *
 * @param moreMessages further messages wait in the centre; on the air the bit is inverted (TP-MMS)
 * @param reference TP-MR of the message reported on
 * @param timestamp TP-SCTS, when the centre took that message
 * @param discharged TP-DT, when it was delivered or last tried
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
        TpduCodec.checkOctet("TP-MR", reference);
        TpduCodec.checkOctet("TP-ST", status);
    }
}
