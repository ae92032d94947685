package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.time.Instant;
import java.time.InstantSource;
import java.util.List;
import java.util.regex.Pattern;
import simgsm.dtmf.DtmfKey;
import simgsm.modem.CallDecision;
import simgsm.modem.Modem;
import simgsm.modem.ModemOptions;
import simgsm.modem.at.AtProfile;
import simgsm.modem.at.command.AtClient;
import simgsm.modem.at.command.AtModem;
import simgsm.modem.at.command.ModemTerminal;
import simgsm.speech.CallAudioListener;
import simgsm.speech.SpeechCodec;
import simgsm.station.MobileStation;
import simgsm.station.StationOptions;
import simgsm.station.context.StationIdentity;
import simgsm.station.mobility.Sim;

/** A modem of a {@link VirtualSuite} and a client of its AT commands, which has switched the echo off. */
final class VirtualModem {
    private static final Pattern RESULT = Pattern.compile(
            "\r\n(OK|ERROR|NO CARRIER|BUSY|NO ANSWER|\\+CM[ES] ERROR: [^\r\n]*)\r\n|\r\n> $|(?:^|[\r\n])([03478]|\\+CM[ES] ERROR: [^\r\n]*)\r");
    /** The longest command is a message that finds no network: 40 s. */
    private static final int MOST_SECONDS = 70;

    VirtualLink link;
    private final VirtualSuite suite;
    private final Modem modem;
    private final AtModem at;
    private final StringBuilder output = new StringBuilder();
    private AtClient client;

    VirtualModem(VirtualSuite suite, StationIdentity identity, AtProfile profile) {
        this.suite = suite;
        modem = new Modem(
                identity,
                Sim.WITHOUT_KEY,
                new ModemOptions(
                        new StationOptions(SpeechCodec.Kind.A_LAW, CallAudioListener.NONE, true),
                        ModemOptions.MAX_ANSWER_AFTER_MILLIS),
                caller -> new CallDecision(true, DtmfKey.ONE),
                event -> {});
        at = new AtModem(new ModemTerminal(modem), profile, InstantSource.fixed(Instant.parse("2026-11-21T12:00:00Z")));
        modem.observe(at::accept);
    }

    MobileStation station() {
        return modem.station();
    }

    void timePassed(long nowNanos) {
        at.timers().advance(nowNanos);
    }

    /** Another client of the same modem, with the settings of a new connection but for the echo. */
    VirtualModem connect() {
        if (client != null) {
            client.close();
        }
        client = at.connect(octets -> output.append(new String(octets, StandardCharsets.ISO_8859_1)));
        return expect("ATE0", "ATE0\r\r\nOK\r\n");
    }

    /** The client closes its connection. */
    void disconnect() {
        client.close();
        client = null;
    }

    /** Sends octets as they are. */
    void send(String octets) {
        client.received(octets.getBytes(StandardCharsets.ISO_8859_1));
        suite.settle();
    }

    /** What the modem has sent since the last call. */
    String heard() {
        String all = output.toString();
        output.setLength(0);
        return all;
    }

    /** Waits for the end of a command or for a prompt. @return all that the modem has sent */
    String result() {
        for (int frame = 0; !RESULT.matcher(output).find(); frame++) {
            assertTrue(frame < MOST_SECONDS * 50, () -> "no final result after " + output);
            suite.seconds(0.02);
        }
        return heard();
    }

    /** Gives a command. @return its answer with the final result and codes right after it, lines separated by a bar */
    String say(String command) {
        output.setLength(0);
        send(command + "\r");
        return lines(result());
    }

    /** Gives a command, and so does a second client before the network has answered. @return the answers of both */
    List<String> sayTogether(String command) {
        StringBuilder second = new StringBuilder();
        AtClient other = at.connect(octets -> second.append(new String(octets, StandardCharsets.ISO_8859_1)));
        other.received("ATE0\r".getBytes(StandardCharsets.ISO_8859_1));
        second.setLength(0);
        output.setLength(0);
        byte[] line = (command + "\r").getBytes(StandardCharsets.ISO_8859_1);
        client.received(line);
        other.received(line);
        suite.seconds(0.5);
        other.close();
        return List.of(lines(heard()), lines(second.toString()));
    }

    /** A message at the prompt. */
    String say(String command, String text) {
        String prompt = say(command);
        assertEquals("> ", prompt, command);
        send(text + "\u001a");
        return lines(result());
    }

    private VirtualModem expect(String command, String exact) {
        output.setLength(0);
        send(command + "\r");
        assertEquals(exact, result());
        return this;
    }

    /** The lines that are not empty, separated by a bar. */
    static String lines(String octets) {
        return octets.strip().equals(">") ? "> " : octets.strip().replaceAll("[\r\n]+", "|");
    }
}
