package simgsm.gateway;

import java.util.Optional;
import simgsm.air.Msisdn;
import simgsm.event.EventLine;
import simgsm.gateway.sip.SipUser;

/** An event of the gateway's console. */
sealed interface GatewayEvent {
    /** Users of pages. */
    String WEB = "web";

    /** Users of SIP phones. */
    String SIP = "sip";

    /** The application of mail. */
    String MAIL = "mail";

    /** The application of fax. */
    String FAX = "fax";

    /** A page has connected, a SIP phone has registered, or an application is bound. */
    @EventLine("joined kind= number= from= [name=]")
    record Joined(String kind, Msisdn number, String from, Optional<String> name) implements GatewayEvent {
        Joined(WebUser user) {
            this(WEB, user.number(), user.from(), nameOf(user));
        }
    }

    /** A page has disconnected, a SIP phone has gone, or an application is bound no longer. */
    @EventLine("left kind= number=")
    record Left(String kind, Msisdn number) implements GatewayEvent {
        Left(WebUser user) {
            this(WEB, user.number());
        }
    }

    /** A page was closed, a SIP request, a mail or a bind refused; the cause is the close code or the reply's. */
    @EventLine("refused kind= from= cause= text=")
    record Refused(String kind, String from, int cause, String text) implements GatewayEvent {}

    /** Answer to {@code users}, idle or call, closed by {@code end of= count=}. */
    @EventLine("user kind= number= from= state= [name=]")
    record UserRow(String kind, Msisdn number, String from, String state, Optional<String> name)
            implements GatewayEvent {
        UserRow(WebUser user) {
            this(WEB, user.number(), user.from(), state(user.isCalling()), nameOf(user));
        }

        UserRow(SipUser user) {
            this(SIP, user.number(), user.from(), state(user.isCalling()), Optional.empty());
        }

        private static String state(boolean isCalling) {
            return isCalling ? "call" : "idle";
        }
    }

    /** The mail server has taken a short message; {@code id} is the left part of its Message-ID. */
    @EventLine("mailed id= to=")
    record Mailed(String id, String to) implements GatewayEvent {}

    /** The mail server has not taken a short message; a reply 4.. is tried again. */
    @EventLine("mail-failed id= to= text=")
    record MailFailed(String id, String to, String text) implements GatewayEvent {}

    /** A message has become a file. */
    @EventLine("fax id= to= file=")
    record Faxed(String id, String to, String file) implements GatewayEvent {}

    /** A message has become no file; the SMSC tries again unless over 50 pages. */
    @EventLine("fax-failed id= to= text=")
    record FaxFailed(String id, String to, String text) implements GatewayEvent {}

    private static Optional<String> nameOf(WebUser user) {
        return Optional.of(user.name()).filter(name -> !name.isEmpty());
    }
}
