package simgsm.station;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import simgsm.air.Msisdn;
import simgsm.station.context.StationEvent;

/** The events of a station, a line each; speech and changes of the snapshot apart. */
final class ReportedEvents implements Consumer<StationEvent> {
    MobileStation station;
    boolean answersAtOnce;
    final List<short[]> heard = new ArrayList<>();
    private final List<String> lines = new ArrayList<>();

    List<String> lines() {
        return List.copyOf(lines);
    }

    void clear() {
        lines.clear();
    }

    @Override
    public void accept(StationEvent event) {
        if (event instanceof StationEvent.SpeechReceived speech) {
            heard.add(speech.samples());
        } else if (event instanceof StationEvent.OfMessage message) {
            accept(message);
        } else if (event instanceof StationEvent.StationRegistered registered) {
            lines.add("registered " + registered.number());
        } else if (event instanceof StationEvent.StationUnregistered unregistered) {
            lines.add("unregistered"
                    + unregistered.cause().map(c -> " " + c.code()).orElse(""));
        } else if (event instanceof StationEvent.Calling calling) {
            lines.add("calling " + calling.number());
        } else if (event instanceof StationEvent.CalledPartyAlerted) {
            lines.add("alerting");
        } else if (event instanceof StationEvent.Ringing ringing) {
            lines.add("ringing " + digits(ringing.from()));
            if (answersAtOnce) {
                station.answer();
            }
        } else if (event instanceof StationEvent.Connected connected) {
            lines.add("connected " + digits(connected.peer()));
        } else if (event instanceof StationEvent.CallWaits waits) {
            lines.add("waiting " + digits(waits.from()));
        } else if (event instanceof StationEvent.CallHeld held) {
            lines.add("held " + digits(held.peer()));
        } else if (event instanceof StationEvent.CallRetrieved retrieved) {
            lines.add("retrieved " + digits(retrieved.peer()));
        } else if (event instanceof StationEvent.HeldCallEnded ended) {
            lines.add("held over " + ended.cause().code());
        } else if (event instanceof StationEvent.HoldRefused) {
            lines.add("hold refused");
        } else if (event instanceof StationEvent.HeldByPeer) {
            lines.add("on hold");
        } else if (event instanceof StationEvent.RetrievedByPeer) {
            lines.add("on hold over");
        } else if (event instanceof StationEvent.Released released) {
            lines.add("released " + released.cause().code());
        } else if (event instanceof StationEvent.NetworkPlaysTones tones) {
            lines.add(tones.playing() ? "network tones" : "own tones");
        } else if (event instanceof StationEvent.KeyStarted key) {
            lines.add("sounds " + key.key().symbol());
        } else if (event instanceof StationEvent.KeyStopping key) {
            lines.add("stopping " + key.key().symbol());
        } else if (event instanceof StationEvent.KeyCompleted key) {
            lines.add("completed " + key.key().symbol());
        } else if (event instanceof StationEvent.UssdReceived ussd) {
            lines.add((ussd.replyExpected() ? "ussd? " : "ussd: ") + ussd.text());
        } else if (event instanceof StationEvent.UssdEnded end) {
            lines.add("ussd over: " + end.how().title()
                    + end.error().map(error -> " " + error.code()).orElse(""));
        } else if (event instanceof StationEvent.KeysRefused refused) {
            lines.add("keys refused " + refused.cause().code());
        }
    }

    private void accept(StationEvent.OfMessage event) {
        if (event instanceof StationEvent.MessageSent sent) {
            lines.add("sent " + sent.id() + " to " + sent.to() + " in " + sent.parts());
        } else if (event instanceof StationEvent.MessageFailed failed) {
            lines.add("failed " + failed.id() + " to " + failed.to() + " "
                    + failed.cause().code());
        } else if (event instanceof StationEvent.MessageDelivered delivered) {
            lines.add("delivered " + delivered.id() + " to " + delivered.to());
        } else if (event instanceof StationEvent.MessageUndelivered undelivered) {
            lines.add(
                    "undelivered " + undelivered.id() + " to " + undelivered.to() + ", status " + undelivered.status());
        } else if (event instanceof StationEvent.ShortMessageReceived message) {
            lines.add("message from " + message.from() + ": " + message.text());
        } else if (event instanceof StationEvent.BroadcastReceived broadcast) {
            lines.add("broadcast " + broadcast.channel() + " in " + broadcast.pages() + ": " + broadcast.text());
        }
    }

    private static String digits(Optional<Msisdn> number) {
        return number.map(Msisdn::digits).orElse("?");
    }
}
