package blackbox.peers;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simgsm.speech.SpeechCodec;
import simgsm.speech.WavWriter;
import simgsm.words.Prompts;
import simgsm.words.SpokenLanguage;
import simgsm.words.Utterance;

/** A recogniser from elsewhere understands the numbers of spoken replies after GSM 06.10 twice. */
@Tag("peer")
class SpokenNumbersTest {
    private static final int NUMBERS = 50;
    private static final int LEAST_READ = 40;

    private static Path spoken(Path folder, int number) throws Exception {
        List<String> words = SpokenLanguage.ENGLISH.number("" + number, "");
        short[] samples = Prompts.of(SpokenLanguage.ENGLISH).samples(new Utterance(words));
        SpeechCodec there = SpeechCodec.Kind.GSM_FULL_RATE.open();
        SpeechCodec here = SpeechCodec.Kind.GSM_FULL_RATE.open();
        Path file = folder.resolve(number + ".wav");
        try (WavWriter wav = new WavWriter(file, 1)) {
            wav.write(new short[1600]);
            for (int at = 0; at < samples.length; at += 160) {
                wav.write(here.decode(there.encode(Arrays.copyOfRange(samples, at, at + 160))));
            }
            wav.write(new short[1600]);
        }
        return file;
    }

    @Test
    void pocketsphinxReadsTheNumbersOfFourInFiveReplies(@TempDir Path folder) throws Exception {
        Peer.SOX.require();
        Peer.require(Peer.PYTHON.run("-c", "import pocketsphinx").status() == 0, "pocketsphinx");
        Random random = new Random(1);
        List<String> command = new ArrayList<>(List.of(Peer.source("pocketsphinx_words.py"), "numbers"));
        for (int i = 0; i < NUMBERS; i++) {
            command.add(spoken(folder, 1 + random.nextInt(i < NUMBERS / 2 ? 360 : 9999))
                    .toString());
        }
        String printed = Peer.PYTHON.run(command.toArray(String[]::new)).expectSuccess();
        List<String> read = printed.lines()
                .filter(line -> {
                    String number = line.replaceFirst(".*/([0-9]+)\\.wav\t.*", "$1");
                    return line.endsWith("\t" + String.join(" ", SpokenLanguage.ENGLISH.number(number, "")));
                })
                .toList();
        System.out.println("  numbers read by pocketsphinx: " + read.size() + " of " + NUMBERS);
        assertTrue(read.size() >= LEAST_READ, printed);
    }
}
