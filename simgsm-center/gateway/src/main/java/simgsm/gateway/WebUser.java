package simgsm.gateway;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import simgsm.air.Direction;
import simgsm.air.Msisdn;
import simgsm.console.Event;
import simgsm.dtmf.DtmfReceiver;
import simgsm.event.EventForm;
import simgsm.gateway.speech.SpeechBuffer;
import simgsm.speech.SpeechCodec;
import simgsm.station.MobileStation;
import simgsm.station.StationOptions;
import simgsm.station.call.MobileCallTable.MobileCallState;
import simgsm.station.context.StationEvent;
import simgsm.station.context.StationIdentity;
import simgsm.station.mobility.Sim;
import simgsm.trace.MessageText;
import simgsm.web.JsonText;
import simgsm.web.WebSocket;
import simgsm.words.PromptListener;

/**
 * One browser as a subscriber: its station, the sound in both directions, and the socket of its page, if connected.
 * Belongs to the stations' thread.
 */
final class WebUser {
    /** Maximum of messages in {@code inbox}; the oldest is removed, because the network has delivered it. */
    private static final int MOST_MESSAGES = 100;

    private static final int MOST_UNACKNOWLEDGED = 20;

    /** Number of layer 3 messages shown to a page that opens its ladder. */
    private static final int MOST_RUNGS = 40;

    private record Received(String from, String text, long millis) {}

    private final String token;
    /** The place of the number in the range of numbers, 0 for the first. */
    private final int place;

    private final int places;
    private final PageWords texts;
    private final SpeechBuffer speech = new SpeechBuffer();
    private final SpeechCodec codec = SpeechCodec.Kind.A_LAW.open();
    private final DtmfReceiver receiver =
            new DtmfReceiver(digit -> keyHeard(digit.key().symbol()));
    private final PromptListener captions =
            new PromptListener(sentence -> tell(Event.of("words").with("text", sentence.text())));
    private final MobileStation station;
    private final List<Received> inbox = new ArrayList<>();
    private final Deque<Event> ladder = new ArrayDeque<>(MOST_RUNGS);
    private boolean isLadderShown;
    private Optional<WebSocket> page = Optional.empty();
    private String from = "";
    private String name = "";
    private boolean isConnected;
    private int messagesRead;
    private int absences;
    private int unacknowledged;
    private boolean isLeaving;

    /**
     * @param place of the number in the range of numbers, 0 for the first
     * @param places numbers in the range; with as many robots, each number has its own
     */
    WebUser(StationIdentity identity, String token, int place, int places, PageWords texts) {
        this.token = token;
        this.place = place;
        this.places = places;
        this.texts = texts;
        station = new MobileStation(identity, Sim.WITHOUT_KEY, StationOptions.STANDARD, speech, this::accept);
    }

    MobileStation station() {
        return station;
    }

    Msisdn number() {
        return station.identity().number();
    }

    String token() {
        return token;
    }

    /** The page's address. */
    String from() {
        return from;
    }

    /** The name of the page's user; may be empty. */
    String name() {
        return name;
    }

    boolean hasPage() {
        return page.isPresent();
    }

    /** Number of times that a page was lost. */
    int absences() {
        return absences;
    }

    /** True if the station detaches for good. */
    boolean isLeaving() {
        return isLeaving;
    }

    void leave() {
        isLeaving = true;
    }

    /**
     * Queues a text.
     *
     * @throws IllegalArgumentException if the queue is full, or the text is too long
     */
    void send(Msisdn to, String text) {
        if (unacknowledged >= MOST_UNACKNOWLEDGED) {
            throw new IllegalArgumentException(MOST_UNACKNOWLEDGED + " messages wait for the network already");
        }
        station.sendMessage(to, text);
        unacknowledged++;
    }

    boolean isCalling() {
        return station.snapshot().callState() != MobileCallState.NULL;
    }

    /**
     * Connects a page; an older one is closed. It receives the earlier messages before the network may send more.
     *
     * @param newName of its user
     */
    void attach(WebSocket socket, String newName) {
        name = newName;
        Optional<WebSocket> older = page;
        page = Optional.of(socket);
        if (older.isPresent()) {
            // a page that has lost its connection has lost its call
            station.hangUp();
            older.get().close(CloseCode.OPENED_ELSEWHERE, "opened elsewhere");
        }
        from = socket.peer().getHostAddress();
        tell(Event.of("welcome")
                .with("number", number())
                .with("token", token)
                .with("place", place)
                .with("places", places));
        tellMessages();
        if (station.snapshot().registered()) {
            tell(Event.of("registered").with("number", number()));
        }
        station.setMemoryAvailable(true);
    }

    /**
     * Disconnects the page. Its call ends, so that the robot stops; the network keeps its messages.
     *
     * @return false if another page has connected
     */
    boolean detach(WebSocket socket) {
        boolean isLast = page.filter(current -> current == socket).isPresent();
        if (isLast) {
            page = Optional.empty();
            isLadderShown = false;
            absences++;
            station.hangUp();
            station.setMemoryAvailable(false);
        }
        return isLast;
    }

    void end(int code, String reason) {
        page.ifPresent(socket -> socket.close(code, reason));
    }

    /** Handles 20 ms of the page's sound. */
    void hear(byte[] octets) {
        if (isConnected) {
            speech.accept(codec.decode(octets));
        }
    }

    private void accept(StationEvent event) {
        if (event instanceof StationEvent.SpeechReceived received) {
            page.ifPresent(socket -> socket.send(codec.encode(received.samples())));
            if (isConnected) {
                receiver.accept(received.samples());
                page.ifPresent(shown -> captions.accept(received.samples()));
            }
            return;
        }
        if (event instanceof StationEvent.MessagePassed passed) {
            keepRung(passed);
            return;
        }
        if (event instanceof StationEvent.Connected) {
            isConnected = true;
            receiver.reset();
            captions.reset();
            speech.clear();
        } else if (event instanceof StationEvent.Released) {
            isConnected = false;
        } else if (event instanceof StationEvent.MessageSent || event instanceof StationEvent.MessageFailed) {
            unacknowledged--;
        } else if (event instanceof StationEvent.ShortMessageReceived message) {
            keep(new Received(message.from(), message.text(), System.currentTimeMillis()));
        }
        if (EventForm.of(event).isPresent()) {
            tell(Event.from(event));
        }
    }

    private void keep(Received message) {
        if (inbox.size() == MOST_MESSAGES) {
            inbox.remove(0);
            messagesRead = Math.max(0, messagesRead - 1);
        }
        inbox.add(message);
    }

    private void keepRung(StationEvent.MessagePassed passed) {
        if (ladder.size() == MOST_RUNGS) {
            ladder.removeFirst();
        }
        Event rung = Event.of("layer3")
                .with("direction", passed.direction() == Direction.UPLINK ? "up" : "down")
                .with("name", MessageText.nameOf(passed.message(), passed.direction()))
                .with("millis", System.currentTimeMillis());
        ladder.addLast(rung);
        if (isLadderShown) {
            tell(rung);
        }
    }

    /** Starts or stops reporting layer 3 messages for the page's ladder, the latest at once. */
    void showLadder(boolean isShown) {
        isLadderShown = isShown;
        if (isShown) {
            ladder.forEach(this::tell);
        }
    }

    private void keyHeard(char key) {
        tell(Event.of("tone").with("key", key).with("meaning", texts.toneMeaning(key)));
    }

    /** Lists the received messages, and marks them as read. */
    void tellInbox() {
        tellMessages();
        tell(Event.of("end").with("of", "inbox").with("count", inbox.size()));
    }

    private void tellMessages() {
        for (int i = 0; i < inbox.size(); i++) {
            Received message = inbox.get(i);
            tell(Event.of("message")
                    .with("from", message.from())
                    .with("text", message.text())
                    .with("millis", message.millis())
                    .with("read", i < messagesRead));
        }
        messagesRead = inbox.size();
    }

    void tellError(String text) {
        tell(Event.of("error").with("text", text));
    }

    private void tell(Event event) {
        page.ifPresent(socket -> socket.send(json(event)));
    }

    private static String json(Event event) {
        JsonText json = new JsonText().open('{').name("event").value(event.name());
        event.fields().forEach((name, value) -> json.name(name).value(value));
        return json.close('}').toString();
    }
}
