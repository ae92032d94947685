package simgsm.words;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import simgsm.dtmf.DtmfReceiver;
import simgsm.speech.SpeechCodec;

class PromptsTest {
    private static byte[] frames(SpokenLanguage language) throws IOException {
        try (InputStream in = Prompts.class.getResourceAsStream(language.code() + ".gsm")) {
            return in.readAllBytes();
        }
    }

    @Test
    void bothLanguagesTakeAtMost150Kilobytes() throws IOException {
        int octets = frames(SpokenLanguage.ENGLISH).length + frames(SpokenLanguage.SPANISH).length;
        assertTrue(octets <= 150_000, "octets: " + octets);
    }

    @ParameterizedTest
    @EnumSource(SpokenLanguage.class)
    void theIndexNamesEveryFrameOnce(SpokenLanguage language) throws IOException {
        Prompts prompts = Prompts.of(language);
        int samples = prompts.names().stream()
                .mapToInt(name -> prompts.samples(new Utterance(List.of(name))).length)
                .sum();
        assertEquals(frames(language).length / 33 * 160, samples);
    }

    @ParameterizedTest
    @EnumSource(SpokenLanguage.class)
    void noKeyIsHeardInAnyPromptByAnyCodec(SpokenLanguage language) {
        Prompts prompts = Prompts.of(language);
        short[] all = prompts.samples(new Utterance(List.copyOf(prompts.names())));
        for (SpeechCodec.Kind kind : SpeechCodec.Kind.values()) {
            StringBuilder heard = new StringBuilder();
            DtmfReceiver receiver = new DtmfReceiver(digit -> heard.append(digit.key()));
            SpeechCodec there = kind.open();
            SpeechCodec here = kind.open();
            for (int at = 0; at < all.length; at += 160) {
                receiver.accept(here.decode(there.encode(Arrays.copyOfRange(all, at, at + 160))));
            }
            receiver.finish();
            assertEquals("", heard.toString(), kind.toString());
        }
    }

    @Test
    void aPersonsRecordingReplacesAPromptAndABrokenOneIsRefusedByName() throws IOException {
        byte[] recording = Arrays.copyOf(frames(SpokenLanguage.SPANISH), 66);
        Prompts own = new Prompts(
                SpokenLanguage.ENGLISH, name -> name.equals("done") ? Optional.of(recording) : Optional.empty());
        Utterance stopped = new Utterance(List.of("stopped"));
        assertEquals(320, own.samples(new Utterance(List.of("done"))).length);
        assertArrayEquals(Prompts.of(SpokenLanguage.ENGLISH).samples(stopped), own.samples(stopped));
        for (byte[] broken : List.of(new byte[33], new byte[0], Arrays.copyOf(recording, 40))) {
            String message = assertThrows(
                            IllegalArgumentException.class,
                            () -> new Prompts(SpokenLanguage.ENGLISH, name -> Optional.of(broken)))
                    .getMessage();
            assertTrue(message.startsWith("prompt zero: "), message);
        }
    }
}
