package simgsm.phone;

import java.util.Optional;
import java.util.function.Consumer;
import simgsm.air.Msisdn;
import simgsm.console.Console;
import simgsm.console.Event;
import simgsm.console.TextBundle;
import simgsm.phone.handset.HandsetEvent;
import simgsm.phone.handset.ToneMeaning;
import simgsm.sms.DeliveryStatus;
import simgsm.station.context.StationEvent;
import simgsm.station.context.UssdEnding;

/** Prints the events of the handset and its station in the console's format; some events are not printed. */
final class PhoneEventPrinter implements Consumer<StationEvent> {
    private final Console console;
    private final TextBundle texts;

    PhoneEventPrinter(Console console, TextBundle texts) {
        this.console = console;
        this.texts = texts;
    }

    @Override
    public void accept(StationEvent event) {
        if (event instanceof StationEvent.StationRegistered registered) {
            console.emit(Event.of("registered").with("number", registered.number()));
        } else if (event instanceof StationEvent.StationUnregistered unregistered) {
            Event line = Event.of("unregistered");
            console.emit(unregistered
                    .cause()
                    .map(cause -> line.with("cause", cause.code()))
                    .orElse(line));
        } else if (event instanceof StationEvent.OfCall ofCall) {
            print(ofCall);
        } else if (event instanceof StationEvent.OfSubmittedMessage message) {
            print(message);
        } else if (event instanceof StationEvent.ShortMessageReceived message) {
            console.emit(Event.of("sms").with("from", message.from()).with("text", message.text()));
        } else if (event instanceof StationEvent.BroadcastReceived broadcast) {
            console.emit(Event.of("broadcast")
                    .with("channel", broadcast.channel())
                    .with("pages", broadcast.pages())
                    .with("text", broadcast.text()));
        } else if (event instanceof StationEvent.OfUssd ofUssd) {
            print(ofUssd);
        } else if (event instanceof HandsetEvent ofHandset) {
            print(ofHandset);
        }
    }

    private void print(StationEvent.OfCall event) {
        if (event instanceof StationEvent.Calling calling) {
            console.emit(Event.of("calling").with("number", calling.number()));
        } else if (event instanceof StationEvent.CalledPartyAlerted) {
            console.emit(Event.of("alerting"));
        } else if (event instanceof StationEvent.Ringing ringing) {
            console.emit(Event.of("ringing").with("from", digits(ringing.from())));
        } else if (event instanceof StationEvent.CallWaits waiting) {
            console.emit(Event.of("waiting").with("from", digits(waiting.from())));
        } else if (event instanceof StationEvent.CallHeld held) {
            console.emit(Event.of("held").with("number", digits(held.peer())));
        } else if (event instanceof StationEvent.CallRetrieved retrieved) {
            console.emit(Event.of("retrieved").with("number", digits(retrieved.peer())));
        } else if (event instanceof StationEvent.HeldCallEnded ended) {
            console.emit(Event.of("held-over").with("cause", ended.cause().code()));
        } else if (event instanceof StationEvent.HeldByPeer peer) {
            console.emit(Event.of(peer.onHold() ? "on-hold" : "on-hold-over"));
        } else if (event instanceof StationEvent.HoldRefused) {
            console.error("hold: the network refuses");
        } else if (event instanceof StationEvent.WaitingCallEnded) {
            console.emit(Event.of("waiting-over"));
        } else if (event instanceof StationEvent.Connected connected) {
            console.emit(Event.of("connected").with("number", digits(connected.peer())));
        } else if (event instanceof StationEvent.Released released) {
            console.emit(Event.of("released")
                    .with("cause", released.cause().code())
                    .with("text", released.cause().title()));
        }
    }

    private static String digits(Optional<Msisdn> number) {
        return number.map(Msisdn::toString).orElse("");
    }

    private void print(StationEvent.OfSubmittedMessage event) {
        if (event instanceof StationEvent.MessageSent sent) {
            console.emit(Event.of("sms-sent")
                    .with("to", sent.to())
                    .with("parts", sent.parts())
                    .with("id", sent.reference()));
        } else if (event instanceof StationEvent.MessageFailed failed) {
            console.emit(Event.of("sms-failed")
                    .with("to", failed.to())
                    .with("cause", failed.cause().code())
                    .with("text", failed.cause().title()));
        } else if (event instanceof StationEvent.MessageDelivered delivered) {
            console.emit(Event.of("sms-delivered").with("to", delivered.to()).with("id", delivered.reference()));
        } else if (event instanceof StationEvent.MessageUndelivered undelivered) {
            console.emit(Event.of("sms-undelivered")
                    .with("to", undelivered.to())
                    .with("id", undelivered.reference())
                    .with("status", undelivered.status())
                    .with("text", DeliveryStatus.title(undelivered.status())));
        }
    }

    private void print(StationEvent.OfUssd event) {
        if (event instanceof StationEvent.UssdReceived text) {
            Event line = Event.of("ussd").with("text", text.text());
            console.emit(text.replyExpected() ? line.with("reply", "expected") : line);
        } else if (event instanceof StationEvent.ServiceAnswered answer) {
            Event line = Event.of("service")
                    .with("code", answer.status().service().typed())
                    .with("state", answer.status().state());
            Event told =
                    answer.status().forwardedTo().map(to -> line.with("to", to)).orElse(line);
            console.emit(answer.status()
                    .noReplySeconds()
                    .map(seconds -> told.with("seconds", seconds))
                    .orElse(told));
        } else if (event instanceof StationEvent.UssdEnded end && end.how() != UssdEnding.COMPLETED) {
            Event line = Event.of("ussd-failed");
            console.emit(end.error()
                    .map(error -> line.with("cause", error.code()).with("text", error.title()))
                    .orElseGet(() -> line.with("text", end.how().title())));
        }
    }

    private void print(HandsetEvent event) {
        if (event instanceof HandsetEvent.KeysSent sent) {
            console.emit(Event.of("sent").with("keys", sent.keys()));
        } else if (event instanceof HandsetEvent.KeysNotSent refused) {
            console.error("press: the network refuses the keys " + refused.keys() + ", cause "
                    + refused.cause().code() + ", " + refused.cause().title());
        } else if (event instanceof HandsetEvent.ImeiShown shown) {
            console.emit(Event.of("imei").with("number", shown.imei()));
        } else if (event instanceof HandsetEvent.SoundPlayed played) {
            console.emit(Event.of("played").with("millis", played.millis()));
        } else if (event instanceof HandsetEvent.ToneHeard heard) {
            String meaning =
                    ToneMeaning.textKey(heard.key()).map(key -> texts.of(key)).orElse("");
            console.emit(Event.of("tone").with("key", heard.key().symbol()).with("meaning", meaning));
        }
    }
}
