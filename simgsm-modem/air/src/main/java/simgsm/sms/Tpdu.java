package simgsm.sms;

/** A transfer protocol data unit of short messages (TS 23.040, 9.2.2). */
public sealed interface Tpdu permits SubmitTpdu, DeliverTpdu, StatusReportTpdu {}
