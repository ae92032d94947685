package simgsm.words;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import simgsm.speech.SpeechCodec;

/**
 * The prompts of one language: spoken words and phrases as GSM 06.10 frames of 33 octets, made by {@code
 * src/main/prompts/make}. Immutable.
 */
public final class Prompts {
    private static final int OCTETS = SpeechCodec.Kind.GSM_FULL_RATE.octetsPerFrame();

    private final SpokenLanguage language;
    private final Map<String, byte[]> frames = new LinkedHashMap<>();

    /**
     * @param recordings supplies a person's own recording of a prompt, which replaces the built-in one: whole frames of
     *     33 octets
     * @throws IllegalArgumentException naming a prompt with other frames
     */
    public Prompts(SpokenLanguage language, Function<String, Optional<byte[]>> recordings) {
        this.language = language;
        byte[] all = resource(language.code() + ".gsm");
        String index = new String(resource(language.code() + ".index"), StandardCharsets.UTF_8);
        int at = 0;
        for (String row : index.lines().toList()) {
            String[] cells = row.split("\t", 2);
            int end = at + OCTETS * Integer.parseInt(cells[0]);
            byte[] builtIn = Arrays.copyOfRange(all, at, end);
            Optional<byte[]> recording = recordings.apply(cells[1]);
            frames.put(cells[1], recording.orElse(builtIn));
            if (recording.isPresent()) {
                samples(cells[1]);
            }
            at = end;
        }
    }

    /** The built-in prompts. */
    public static Prompts of(SpokenLanguage language) {
        return new Prompts(language, name -> Optional.empty());
    }

    private static byte[] resource(String name) {
        try (InputStream in = Prompts.class.getResourceAsStream(name)) {
            return in.readAllBytes();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    public SpokenLanguage language() {
        return language;
    }

    /** The prompts' names: their words in the language's spelling. */
    public Set<String> names() {
        return frames.keySet();
    }

    /** A sentence's speech, 8 kHz, in whole frames of 160 samples. @throws IllegalArgumentException for an unknown prompt */
    public short[] samples(Utterance utterance) {
        List<short[]> parts = utterance.prompts().stream().map(this::samples).toList();
        short[] joined = new short[parts.stream().mapToInt(part -> part.length).sum()];
        int at = 0;
        for (short[] part : parts) {
            System.arraycopy(part, 0, joined, at, part.length);
            at += part.length;
        }
        return joined;
    }

    private short[] samples(String name) {
        byte[] octets = frames.getOrDefault(name, new byte[0]);
        if (octets.length == 0 || octets.length % OCTETS != 0) {
            throw new IllegalArgumentException(
                    "prompt " + name + ": expected GSM 06.10 frames of 33 octets, found " + octets.length + " octets");
        }
        SpeechCodec decoder = SpeechCodec.Kind.GSM_FULL_RATE.open();
        short[] samples = new short[octets.length / OCTETS * SpeechCodec.SAMPLES_PER_FRAME];
        for (int i = 0; i < octets.length / OCTETS; i++) {
            short[] frame = decoded(decoder, name, Arrays.copyOfRange(octets, i * OCTETS, (i + 1) * OCTETS));
            System.arraycopy(frame, 0, samples, i * frame.length, frame.length);
        }
        return samples;
    }

    private static short[] decoded(SpeechCodec decoder, String name, byte[] frame) {
        try {
            return decoder.decode(frame);
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException("prompt " + name + ": " + e.getMessage(), e);
        }
    }
}
