package simgsm.gateway;

import java.util.Optional;
import simgsm.air.Msisdn;
import simgsm.event.EventLine;

/** An event of the gateway's console. */
sealed interface GatewayEvent {
    /** Users of pages. */
    String WEB = "web";

    /** A page has connected. */
    @EventLine("joined kind= number= from= [name=]")
    record Joined(String kind, Msisdn number, String from, Optional<String> name) implements GatewayEvent {
        Joined(WebUser user) {
            this(WEB, user.number(), user.from(), nameOf(user));
        }
    }

    /** A page has disconnected. */
    @EventLine("left kind= number=")
    record Left(String kind, Msisdn number) implements GatewayEvent {
        Left(WebUser user) {
            this(WEB, user.number());
        }
    }

    /** A page was closed; the cause is its close code. */
    @EventLine("refused kind= from= cause= text=")
    record Refused(String kind, String from, int cause, String text) implements GatewayEvent {}

    /** Answer to {@code users}, idle or call, closed by {@code end of= count=}. */
    @EventLine("user kind= number= from= state= [name=]")
    record UserRow(String kind, Msisdn number, String from, String state, Optional<String> name)
            implements GatewayEvent {
        UserRow(WebUser user) {
            this(WEB, user.number(), user.from(), user.isCalling() ? "call" : "idle", nameOf(user));
        }
    }

    private static Optional<String> nameOf(WebUser user) {
        return Optional.of(user.name()).filter(name -> !name.isEmpty());
    }
}
