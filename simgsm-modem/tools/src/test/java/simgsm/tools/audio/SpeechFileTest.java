package simgsm.tools.audio;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Random;
import javax.sound.sampled.AudioFileFormat;
import javax.sound.sampled.AudioFormat;
import javax.sound.sampled.AudioFormat.Encoding;
import javax.sound.sampled.AudioInputStream;
import javax.sound.sampled.AudioSystem;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.speech.WavWriter;

class SpeechFileTest {
    @TempDir
    Path folder;

    @Test
    void whatIsWrittenIsReadBackExactly() throws IOException {
        short[] samples = new short[10_007];
        Random random = new Random(1);
        for (int i = 0; i < samples.length; i++) {
            samples[i] = (short) random.nextInt();
        }
        Path file = folder.resolve("a.wav");
        WavWriter.write(file, samples);
        assertArrayEquals(samples, WholeSpeechFile.read(file));
        assertEquals(44 + 2 * samples.length, Files.size(file));
    }

    @Test
    void aRecordingOfTwoChannelsIsMixed() throws IOException {
        Path file = folder.resolve("two.wav");
        try (WavWriter writer = new WavWriter(file, 2)) {
            writer.write(new short[] {100, 300, -4, 4});
            writer.write(new short[] {32767, 32767});
        }
        assertArrayEquals(new short[] {200, 0, 32767}, WholeSpeechFile.read(file));
    }

    @Test
    void anEmptyRecordingIsAudioOfNoLength() throws IOException {
        Path file = folder.resolve("empty.wav");
        WavWriter.write(file, new short[0]);
        assertEquals(0, WholeSpeechFile.read(file).length);
    }

    @ParameterizedTest
    @ValueSource(ints = {11_025, 16_000, 22_050, 44_100, 48_000, 96_000, 44_101})
    void otherRatesKeepLevelFrequencyAndTime(int rate) throws IOException {
        float[] sound = new float[rate];
        for (int i = 0; i < rate; i++) {
            sound[i] = (float) (0.25 * Math.sin(2 * Math.PI * 1336 * i / rate));
        }
        Path file = write("r.wav", sound, new AudioFormat(Encoding.PCM_FLOAT, rate, 32, 1, 4, rate, false));
        short[] speech = WholeSpeechFile.read(file);
        assertEquals(8000, speech.length);
        for (int i = 200; i < 7800; i++) {
            assertEquals(8192 * Math.sin(2 * Math.PI * 1336 * i / 8000), speech[i], 2.5, "sample " + i);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {4_000, 6_000, 11_025, 16_000, 44_100, 48_000})
    void forKeysTheirTonesComeSoonerAndAsWell(int rate) throws IOException {
        float[] sound = new float[rate];
        for (int i = 0; i < rate; i++) {
            sound[i] = (float) (0.25 * Math.sin(2 * Math.PI * 1633 * i / rate));
        }
        Path path = write("r.wav", sound, new AudioFormat(Encoding.PCM_FLOAT, rate, 32, 1, 4, rate, false));
        try (SpeechFile steep = SpeechFile.open(path);
                SpeechFile file = SpeechFile.openForKeys(path)) {
            short[] speech = new short[8000];
            assertEquals(8000, file.read(speech));
            for (int i = 200; i < 7800; i++) {
                assertEquals(8192 * Math.sin(2 * Math.PI * 1633 * i / 8000), speech[i], 250, "sample " + i);
            }
            assertTrue(rate < 5000 || file.lookAheadMillis() < 1, file.lookAheadMillis() + " ms");
            assertTrue(file.lookAheadMillis() <= steep.lookAheadMillis());
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {16_000, 44_100, 48_000})
    void whatLiesBeyondSpeechDoesNotFoldBack(int rate) throws IOException {
        float[] sound = new float[rate];
        for (int i = 0; i < rate; i++) {
            // Would come back as 1336 Hz.
            sound[i] = (float) (0.5 * Math.sin(2 * Math.PI * (8000 - 1336) * i / rate));
        }
        Path file = write("r.wav", sound, new AudioFormat(Encoding.PCM_FLOAT, rate, 32, 1, 4, rate, false));
        short[] speech = WholeSpeechFile.read(file);
        for (int i = 200; i < 7800; i++) {
            assertEquals(0, speech[i], 5);
        }
    }

    @Test
    void aSlowRateIsRaised() throws IOException {
        float[] sound = new float[6000];
        for (int i = 0; i < sound.length; i++) {
            sound[i] = (float) (0.25 * Math.sin(2 * Math.PI * 941 * i / 6000));
        }
        Path file = write("r.wav", sound, new AudioFormat(Encoding.PCM_FLOAT, 6000, 32, 1, 4, 6000, false));
        short[] speech = WholeSpeechFile.read(file);
        assertEquals(8000, speech.length);
        for (int i = 200; i < 7800; i++) {
            assertEquals(8192 * Math.sin(2 * Math.PI * 941 * i / 8000), speech[i], 2.5, "sample " + i);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {8, 16, 24, 32})
    void everyWidthComesOutOnOneScale(int bits) throws IOException {
        float[] ramp = new float[200];
        for (int i = 0; i < ramp.length; i++) {
            ramp[i] = (i - 100) / 128f;
        }
        AudioFormat format = new AudioFormat(
                bits == 8 ? Encoding.PCM_UNSIGNED : Encoding.PCM_SIGNED, 8000, bits, 1, bits / 8, 8000, false);
        short[] speech = WholeSpeechFile.read(write("w.wav", ramp, format));
        for (int i = 0; i < ramp.length; i++) {
            assertEquals(256 * (i - 100), speech[i], 1);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"au", "aif"})
    void otherContainersAreReadToo(String extension) throws IOException {
        float[] ramp = new float[100];
        for (int i = 0; i < ramp.length; i++) {
            ramp[i] = i / 128f;
        }
        Path file = write("o." + extension, ramp, new AudioFormat(Encoding.PCM_SIGNED, 8000, 16, 1, 2, 8000, true));
        short[] speech = WholeSpeechFile.read(file);
        assertEquals(256 * 99, speech[99]);
    }

    @Test
    void companded8BitFilesAreExpanded() throws IOException {
        byte[] octets = {(byte) 0xD5, 0x55, 0x2A, (byte) 0xAA};
        AudioFormat format = new AudioFormat(Encoding.ALAW, 8000, 8, 1, 1, 8000, false);
        Path file = folder.resolve("alaw.wav");
        AudioSystem.write(
                new AudioInputStream(new ByteArrayInputStream(octets), format, 4),
                AudioFileFormat.Type.WAVE,
                file.toFile());
        assertArrayEquals(new short[] {8, -8, -32256, 32256}, WholeSpeechFile.read(file));
    }

    @Test
    void aFileCutShortGivesWhatThereIs() throws IOException {
        Path file = folder.resolve("cut.wav");
        WavWriter.write(file, new short[1000]);
        Files.write(file, Arrays.copyOf(Files.readAllBytes(file), 44 + 501));
        assertEquals(250, WholeSpeechFile.read(file).length);
    }

    @Test
    void chunksThatDoNotMatterArePassedOver() throws IOException {
        byte[] list = chunk("LIST", bytes("INFOx"), 5);
        byte[] large = chunk("JUNK", new byte[200_000], 200_000);
        byte[] sound = chunk("data", SOUND, SOUND.length);
        assertRamp(riff(list, SPEECH, list, sound, list));
        assertRamp(riff(large, SPEECH, sound));
        assertRamp(riff(SPEECH, chunk("fact", new byte[4], 4), sound, large));
    }

    @Test
    void aFormatIsReadInEveryWayThatItIsWritten() throws IOException {
        byte[] sound = chunk("data", SOUND, SOUND.length);
        assertRamp(riff(chunk("fmt ", join(FORMAT, new byte[2]), 18), sound));
        byte[] rest = join(new byte[] {22, 0, 16, 0, 4, 0, 0, 0, 1, 0}, GUID_END);
        byte[] extensible = join(new byte[] {(byte) 0xFE, (byte) 0xFF}, Arrays.copyOfRange(FORMAT, 2, 16), rest);
        assertRamp(riff(chunk("fmt ", extensible, 40), sound));
        byte[] noBlock = FORMAT.clone();
        noBlock[12] = 0;
        assertRamp(riff(chunk("fmt ", noBlock, 16), sound));
    }

    @ParameterizedTest
    @ValueSource(longs = {0, 0xFFFF_FFFFL, 0x7FFF_FFFFL, 4001, 1 << 20})
    void aLengthThatWasNeverFilledInMeansToTheEnd(long length) throws IOException {
        assertRamp(riff(SPEECH, chunk("data", SOUND, length)));
        byte[] wide = FORMAT.clone();
        wide[2] = 2;
        wide[12] = 4;
        assertEquals(1000, read(riff(chunk("fmt ", wide, 16), chunk("data", SOUND, length))).length);
    }

    @Test
    void aLengthThatIsShorterThanTheFileIsBelieved() throws IOException {
        byte[] tail = chunk("LIST", bytes("INFO"), 4);
        assertEquals(500, read(riff(SPEECH, chunk("data", SOUND, 1000))).length);
        assertEquals(500, read(riff(SPEECH, chunk("data", SOUND, 1001))).length);
        assertEquals(0, read(riff(SPEECH, chunk("data", new byte[0], 0), tail)).length);
        assertEquals(0, read(riff(SPEECH, chunk("data", new byte[0], 0))).length);
    }

    @Test
    void aRecordingOfMoreThan4GiBHasItsLengthElsewhere() throws IOException {
        byte[] lengths = ByteBuffer.allocate(28)
                .order(ByteOrder.LITTLE_ENDIAN)
                .putLong(0)
                .putLong(SOUND.length)
                .array();
        byte[] file = riff(
                chunk("ds64", lengths, 28),
                SPEECH,
                chunk("data", SOUND, 0xFFFF_FFFFL),
                chunk("LIST", new byte[10], 10));
        file[1] = 'F';
        file[2] = '6';
        file[3] = '4';
        assertRamp(file);
    }

    @Test
    void soundAcrossTheEndOfTheFirstBlockReadIsWhole() throws IOException {
        for (int length : new int[] {65_490, 65_491, 65_492, 65_493, 131_028, 200_000}) {
            byte[] sound = new byte[length];
            new Random(length).nextBytes(sound);
            short[] samples = new short[length / 2];
            ByteBuffer.wrap(sound)
                    .order(ByteOrder.LITTLE_ENDIAN)
                    .asShortBuffer()
                    .get(samples);
            assertArrayEquals(samples, read(riff(SPEECH, chunk("data", sound, length))));
        }
    }

    @Test
    void aFolderIsNoAudio() {
        assertThrows(NotAudioException.class, () -> SpeechFile.open(folder));
    }

    private static final byte[] GUID_END = {
        0, 0, 0, 0, 0x10, 0, (byte) 0x80, 0, 0, (byte) 0xAA, 0, 0x38, (byte) 0x9B, 0x71
    };
    /** 8 kHz, 16 bit, mono. */
    private static final byte[] FORMAT = {1, 0, 1, 0, 0x40, 0x1F, 0, 0, (byte) 0x80, 0x3E, 0, 0, 2, 0, 16, 0};

    private static final byte[] SPEECH = chunk("fmt ", FORMAT, 16);
    private static final byte[] SOUND = new byte[4000];

    static {
        for (short i = 0; i < 2000; i++) {
            ByteBuffer.wrap(SOUND).order(ByteOrder.LITTLE_ENDIAN).putShort(2 * i, (short) (7 * i - 6000));
        }
    }

    private void assertRamp(byte[] file) throws IOException {
        short[] samples = read(file);
        assertEquals(2000, samples.length);
        for (int i = 0; i < 2000; i++) {
            assertEquals(7 * i - 6000, samples[i]);
        }
    }

    private short[] read(byte[] file) throws IOException {
        return WholeSpeechFile.read(Files.write(folder.resolve("made.wav"), file));
    }

    private static byte[] riff(byte[]... chunks) {
        return join(bytes("RIFF"), new byte[4], bytes("WAVE"), join(chunks));
    }

    private static byte[] chunk(String id, byte[] content, long length) {
        byte[] field = Arrays.copyOf(
                ByteBuffer.allocate(8)
                        .order(ByteOrder.LITTLE_ENDIAN)
                        .putLong(length)
                        .array(),
                4);
        return join(bytes(id), field, content, new byte[content.length % 2]);
    }

    private static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.US_ASCII);
    }

    private static byte[] join(byte[]... parts) {
        ByteArrayOutputStream whole = new ByteArrayOutputStream();
        for (byte[] part : parts) {
            whole.writeBytes(part);
        }
        return whole.toByteArray();
    }

    @Test
    void whatIsNoAudioIsSaidToBeNone() throws IOException {
        Path text = Files.writeString(folder.resolve("a.txt"), "hello");
        assertThrows(NotAudioException.class, () -> SpeechFile.open(text));
        Path nothing = Files.write(folder.resolve("nothing.wav"), new byte[0]);
        assertThrows(NotAudioException.class, () -> SpeechFile.open(nothing));
        assertThrows(NoSuchFileException.class, () -> SpeechFile.open(folder.resolve("missing.wav")));
    }

    @Test
    void damagedHeadersNeverThrowAnythingButInputOutputErrors() throws IOException {
        Path file = folder.resolve("good.wav");
        WavWriter.write(file, new short[400]);
        byte[] good = Files.readAllBytes(file);
        Random random = new Random(3);
        int readable = 0;
        for (int i = 0; i < 500; i++) {
            byte[] bad = good.clone();
            for (int k = 0; k <= i % 4; k++) {
                bad[random.nextInt(44)] = (byte) random.nextInt();
            }
            Files.write(file, bad);
            try {
                assertTrue(WholeSpeechFile.read(file).length <= 400 * 4000);
                readable++;
            } catch (IOException e) {
                assertTrue(e.getMessage() != null);
            }
        }
        assertTrue(readable > 25, readable + " readable");
    }

    private Path write(String name, float[] sound, AudioFormat format) throws IOException {
        ByteBuffer buffer = ByteBuffer.allocate(sound.length * format.getFrameSize())
                .order(format.isBigEndian() ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN);
        for (float sample : sound) {
            switch (format.getSampleSizeInBits()) {
                case 8 -> buffer.put((byte) (128 + 128 * sample));
                case 16 -> buffer.putShort((short) (32768 * sample));
                case 24 -> {
                    int value = (int) (8388608 * sample);
                    buffer.put((byte) value).put((byte) (value >> 8)).put((byte) (value >> 16));
                }
                default -> {
                    if (format.getEncoding().equals(Encoding.PCM_FLOAT)) {
                        buffer.putFloat(sample);
                    } else {
                        buffer.putInt((int) (2147483648.0 * sample));
                    }
                }
            }
        }
        AudioFileFormat.Type type = name.endsWith(".au")
                ? AudioFileFormat.Type.AU
                : name.endsWith(".aif") ? AudioFileFormat.Type.AIFF : AudioFileFormat.Type.WAVE;
        Path file = folder.resolve(name);
        AudioSystem.write(
                new AudioInputStream(new ByteArrayInputStream(buffer.array()), format, sound.length),
                type,
                file.toFile());
        return file;
    }
}
