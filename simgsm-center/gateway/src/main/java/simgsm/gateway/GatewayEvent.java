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

    /** A page has connected, or a SIP phone has registered. */
    @EventLine("joined kind= number= from= [name=]")
    record Joined(String kind, Msisdn number, String from, Optional<String> name) implements GatewayEvent {
        Joined(WebUser user) {
            this(WEB, user.number(), user.from(), nameOf(user));
        }
    }

    /** A page has disconnected, or a SIP phone has gone. */
    @EventLine("left kind= number=")
    record Left(String kind, Msisdn number) implements GatewayEvent {
        Left(WebUser user) {
            this(WEB, user.number());
        }
    }

    /** A page was closed, or a SIP request refused; the cause is the close code or the response. */
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

    private static Optional<String> nameOf(WebUser user) {
        return Optional.of(user.name()).filter(name -> !name.isEmpty());
    }
}
