package simgsm.modem.client;

import java.nio.charset.StandardCharsets;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import simgsm.air.Msisdn;
import simgsm.dtmf.DtmfKey;
import simgsm.modem.CallDecision;
import simgsm.modem.ModemEvent;
import simgsm.modem.ModemState;
import simgsm.station.context.StationEvent;

/** A client with a modem that answers by a list, at once; what it says unasked and the time are given by hand. */
final class ModemBench {
    static final Msisdn NUMBER = new Msisdn("5550200");
    /** Earlier than the messages of the tests. */
    static final Instant START = Instant.parse("2026-11-22T00:00:00Z");

    static final String NO_ANSWER = "(no answer)";

    final List<String> sent = new ArrayList<>();
    final List<String> events = new ArrayList<>();
    /** Each state with its text, as it changes. */
    final List<String> states = new ArrayList<>();
    /** The answer to a command, lines separated by |, with its final result; all others are answered by OK. */
    final Map<String, String> answers = new HashMap<>(Map.of(
            "AT+CGMI", "SIMCOM|OK",
            "AT+CGMM", "SIM800|OK",
            "AT+CPIN?", "+CPIN: READY|OK",
            "AT+DDET?", "+DDET: 1,0,1,0|OK",
            "AT+COPS?", "+COPS: 0,0,\"TestNet\"|OK",
            "AT+CREG?", "+CREG: 1,1|OK"));

    final AttachedModem modem;
    CallDecision decision = new CallDecision(true, DtmfKey.ONE);
    private final StringBuilder input = new StringBuilder();
    private final List<String> due = new ArrayList<>();
    long nowNanos;

    ModemBench() {
        this(1500);
    }

    ModemBench(int answerAfterMillis) {
        this(answerAfterMillis, SoundPort.NONE);
    }

    ModemBench(int answerAfterMillis, SoundPort sound) {
        modem = new AttachedModem(
                NUMBER, answerAfterMillis, START, this::fromClient, sound, caller -> decision, this::accept);
    }

    private void fromClient(String octets) {
        for (char octet : octets.toCharArray()) {
            if (octet == '\r' || octet == '\u001a') {
                sent.add(input.toString());
                due.add(answers.getOrDefault(input.toString(), "OK"));
                input.setLength(0);
            } else if (octet != '\u001b') {
                input.append(octet);
            }
        }
    }

    private void accept(StationEvent event) {
        if (event instanceof ModemEvent.StateChanged changed) {
            states.add(changed.state().word() + " " + changed.text());
            return;
        }
        if (event instanceof ModemEvent.SpeechProcessed) {
            return;
        }
        if (event instanceof ModemEvent.KeyDecided key) {
            events.add("key " + key.digit().key().symbol() + " " + key.digit().durationMillis());
        } else if (event instanceof StationEvent.Released released) {
            events.add("released " + released.cause().code());
        } else if (event instanceof StationEvent.Ringing ringing) {
            events.add("ringing " + ringing.from().map(Msisdn::digits).orElse(""));
        } else if (event instanceof StationEvent.ShortMessageReceived message) {
            events.add("sms " + message.from() + " " + message.text());
        } else if (event instanceof StationEvent.MessageFailed failed) {
            events.add("failed " + failed.id() + " " + failed.cause().code());
        } else if (event instanceof StationEvent.MessageSent message) {
            events.add("sent " + message.id() + " " + message.parts());
        } else if (event instanceof ModemEvent.ReplyToneSent tone) {
            events.add("tone " + tone.key().symbol());
        } else {
            events.add(event.getClass().getSimpleName());
        }
    }

    /** Octets of the modem, as they are. */
    void octets(String octets) {
        modem.received(octets.getBytes(StandardCharsets.ISO_8859_1), nowNanos);
    }

    void say(String... lines) {
        for (String line : lines) {
            octets("\r\n" + line + "\r\n");
        }
    }

    void millis(long millis) {
        for (long step = 0; step < millis; step += 10) {
            nowNanos += 10_000_000;
            modem.timePassed(nowNanos);
            answer();
        }
    }

    private void answer() {
        while (!due.isEmpty()) {
            String answer = due.remove(0);
            if (answer.startsWith("> ")) {
                octets("\r\n> ");
            } else if (!answer.equals(NO_ANSWER)) {
                say(answer.split("\\|"));
            }
        }
    }

    ModemBench ready() {
        modem.lineUp(nowNanos);
        millis(2000);
        return this;
    }

    ModemBench inCall() {
        answers.put("AT+CLCC", "+CLCC: 1,1,4,0,0,\"5550100\",129|OK");
        say("RING", "+CLIP: \"5550100\",129");
        millis(1600);
        answers.put("AT+CLCC", "+CLCC: 1,1,0,0,0,\"5550100\",129|OK");
        millis(500);
        return this;
    }

    boolean isReady() {
        return modem.state().state() == ModemState.READY;
    }

    /** The events since the last look. */
    List<String> news() {
        List<String> news = List.copyOf(events);
        events.clear();
        return news;
    }

    Optional<String> lastSent() {
        return sent.isEmpty() ? Optional.empty() : Optional.of(sent.get(sent.size() - 1));
    }
}
