package simgsm.phone.handset;

import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import simgsm.air.Msisdn;
import simgsm.dtmf.DtmfKey;
import simgsm.phone.screen.ServiceWords;
import simgsm.phone.screen.Words;
import simgsm.station.context.StationEvent;

/** What just happened, in words and in the order of time: the newest {@value #CAPACITY} events that concern the user. */
public final class HandsetLog {
    static final int CAPACITY = 300;
    /** Keys in one event, three lines in the window; further ones begin the next event. */
    static final int MOST_KEYS = 64;

    /** An event. @param words for the user, in the phone's language when they are shown */
    public record Entry(Instant at, Words words) {}

    private final InstantSource wallClock;
    private final UnaryOperator<String> names;
    private final Deque<Entry> entries = new ArrayDeque<>();
    private List<Entry> published = List.of();
    private boolean isPublished = true;

    /** @param names the name of a number */
    HandsetLog(InstantSource wallClock, UnaryOperator<String> names) {
        this.wallClock = wallClock;
        this.names = names;
    }

    /** Oldest first; the same list until the next event. */
    List<Entry> entries() {
        if (!isPublished) {
            published = List.copyOf(entries);
            isPublished = true;
        }
        return published;
    }

    private void add(String key, Object... arguments) {
        if (entries.size() == CAPACITY) {
            entries.removeFirst();
        }
        entries.addLast(new Entry(wallClock.instant(), Words.of(key, arguments)));
        isPublished = false;
    }

    /** The user keys a tone in the call: up to {@value #MOST_KEYS} keys are one event, until something else happens. */
    void keyed(DtmfKey key) {
        String keys = String.valueOf(key.symbol());
        Entry last = entries.peekLast();
        String before = last != null && last.words().key().equals("log.keys")
                ? (String) last.words().arguments().get(0)
                : "";
        if (!before.isEmpty() && before.length() < MOST_KEYS) {
            entries.removeLast();
            add("log.keys", before + keys);
        } else {
            add("log.keys", keys);
        }
    }

    /** Adds what the user is to know of the event. */
    void accept(StationEvent event) {
        if (event instanceof StationEvent.StationRegistered registered) {
            add("log.registered", registered.number().digits());
        } else if (event instanceof StationEvent.StationUnregistered) {
            add("log.unregistered");
        } else if (event instanceof StationEvent.OfCall call) {
            acceptCall(call);
        } else if (event instanceof HandsetEvent ofHandset) {
            acceptHandset(ofHandset);
        } else if (event instanceof StationEvent.OfSubmittedMessage message) {
            acceptSubmitted(message);
        } else if (event instanceof StationEvent.ShortMessageReceived message) {
            add("log.message", names.apply(message.from()), message.text());
        } else if (event instanceof StationEvent.BroadcastReceived broadcast) {
            add("log.broadcast", String.valueOf(broadcast.channel()), broadcast.text());
        } else if (event instanceof StationEvent.OfUssd ofUssd) {
            acceptUssd(ofUssd);
        }
    }

    private void acceptCall(StationEvent.OfCall event) {
        if (event instanceof StationEvent.Calling calling) {
            add("log.calling", names.apply(calling.number().toString()));
        } else if (event instanceof StationEvent.CalledPartyAlerted) {
            add("lcd.call.alerting");
        } else if (event instanceof StationEvent.Ringing ringing) {
            add("log.ringing", party(ringing.from()));
        } else if (event instanceof StationEvent.Connected connected) {
            add("log.connected", party(connected.peer()));
        } else if (event instanceof StationEvent.CallWaits waits) {
            add("lcd.waiting", party(waits.from()));
        } else if (event instanceof StationEvent.WaitingCallEnded) {
            add("log.waiting_over");
        } else if (event instanceof StationEvent.CallHeld held) {
            add("lcd.held", party(held.peer()));
        } else if (event instanceof StationEvent.CallRetrieved retrieved) {
            add("log.retrieved", party(retrieved.peer()));
        } else if (event instanceof StationEvent.HeldCallEnded) {
            add("log.held_over");
        } else if (event instanceof StationEvent.HeldByPeer peer) {
            add(peer.onHold() ? "lcd.on_hold_by_peer" : "log.on_hold_over");
        } else if (event instanceof StationEvent.HoldRefused) {
            add("note.refused");
        } else if (event instanceof StationEvent.Released released) {
            add("log.released", released.cause());
        }
    }

    private Object party(Optional<Msisdn> number) {
        return number.<Object>map(it -> names.apply(it.toString())).orElse(Words.of("lcd.unknown"));
    }

    private void acceptHandset(HandsetEvent event) {
        if (event instanceof HandsetEvent.KeysNotSent refused) {
            add("note.keys_refused", String.valueOf(refused.cause().code()));
        } else if (event instanceof HandsetEvent.ImeiShown shown) {
            add("log.imei", shown.imei());
        } else if (event instanceof HandsetEvent.ToneHeard heard) {
            String key = String.valueOf(heard.key().symbol());
            heard.meaning()
                    .ifPresentOrElse(
                            meaning -> add("log.tone", key, Words.of(meaning)), () -> add("log.tone.plain", key));
        }
    }

    private void acceptSubmitted(StationEvent.OfSubmittedMessage event) {
        if (event instanceof StationEvent.MessageSent sent) {
            add("log.message.sent", names.apply(sent.to().toString()));
        } else if (event instanceof StationEvent.MessageFailed failed) {
            add("log.message.failed", names.apply(failed.to().toString()), failed.cause());
        } else if (event instanceof StationEvent.MessageDelivered delivered) {
            add("log.message.delivered", names.apply(delivered.to().toString()));
        } else if (event instanceof StationEvent.MessageUndelivered lost) {
            add("log.message.undelivered", names.apply(lost.to().toString()));
        }
    }

    private void acceptUssd(StationEvent.OfUssd event) {
        if (event instanceof StationEvent.UssdReceived text) {
            add("log.network", text.text());
        } else if (event instanceof StationEvent.ServiceAnswered answer) {
            add("log.service", ServiceWords.title(answer.status()), ServiceWords.state(answer.status()));
        } else if (event instanceof StationEvent.UssdEnded end) {
            ServiceWords.noteOf(end).ifPresent(note -> add("log.service.none", note));
        }
    }
}
