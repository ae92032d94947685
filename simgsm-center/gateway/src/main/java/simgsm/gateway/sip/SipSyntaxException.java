package simgsm.gateway.sip;

/** A datagram that is not a SIP message. Without a stack trace, because peers cause any number of them. */
final class SipSyntaxException extends Exception {
    SipSyntaxException(String text) {
        super(text, null, false, false);
    }
}
