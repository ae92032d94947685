package blackbox.fuzz;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.HexFormat;
import java.util.List;
import simgsm.abis.IpaFrame;
import simgsm.air.Direction;
import simgsm.octets.Octets;

/** Recorded frames, a few of each message type. */
final class RecordedFrames {
    /** A frame and its direction. */
    record Sample(Direction direction, IpaFrame frame) {}

    private static final String RESOURCE = "traffic.txt";

    private RecordedFrames() {}

    static List<Sample> read() {
        try (BufferedReader lines = new BufferedReader(
                new InputStreamReader(RecordedFrames.class.getResourceAsStream(RESOURCE), StandardCharsets.US_ASCII))) {
            return lines.lines()
                    .filter(line -> !line.startsWith("#"))
                    .map(RecordedFrames::sample)
                    .toList();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static Sample sample(String line) {
        String[] words = line.split(" ");
        byte[] wire = HexFormat.of().parseHex(words[1]);
        byte[] payload = Octets.range(wire, IpaFrame.HEADER_LENGTH, wire.length);
        return new Sample(
                words[0].equals("up") ? Direction.UPLINK : Direction.DOWNLINK, new IpaFrame(wire[2] & 0xff, payload));
    }
}
