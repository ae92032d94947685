package simgsm.tools.fuzz;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import simgsm.abis.IpaFrame;
import simgsm.air.Direction;

/** Frames that really crossed a wire, each kind of message a few times. */
final class Traffic {
    /** One of them. */
    record Sample(Direction direction, IpaFrame frame) {}

    private static final String RESOURCE = "traffic.txt";

    private Traffic() {}

    static List<Sample> read() {
        try (BufferedReader lines = new BufferedReader(
                new InputStreamReader(Traffic.class.getResourceAsStream(RESOURCE), StandardCharsets.US_ASCII))) {
            return lines.lines()
                    .filter(line -> !line.startsWith("#"))
                    .map(Traffic::sample)
                    .toList();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static Sample sample(String line) {
        String[] words = line.split(" ");
        byte[] wire = HexFormat.of().parseHex(words[1]);
        byte[] payload = Arrays.copyOfRange(wire, IpaFrame.HEADER_LENGTH, wire.length);
        return new Sample(
                words[0].equals("up") ? Direction.UPLINK : Direction.DOWNLINK, new IpaFrame(wire[2] & 0xff, payload));
    }
}
