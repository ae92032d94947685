package simgsm.audio;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.ByteChannel;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import javax.sound.sampled.AudioFormat;
import javax.sound.sampled.AudioSystem;
import javax.sound.sampled.DataLine;
import javax.sound.sampled.Line;
import javax.sound.sampled.LineUnavailableException;
import javax.sound.sampled.Mixer;
import javax.sound.sampled.SourceDataLine;
import javax.sound.sampled.TargetDataLine;
import simgsm.net.ByteLine;
import simgsm.speech.AudioOutput;
import simgsm.speech.PcmFrames;

/**
 * A sound device as a line: its input is read, its output is written, at 8 kHz, 16 bit, mono, little-endian.
 *
 * @param name part of the device's name in any case; empty for the system's default
 */
public record SoundCardLine(String name) implements ByteLine {
    @Override
    public ByteChannel open() throws IOException {
        return open(this::input, this::output);
    }

    static ByteChannel open(Microphone.Lines input, SoundCard.Lines output) throws IOException {
        // an input alone would stay open: its call is heard, and never answered
        SoundCard.require(output);
        return new Channel(Microphone.started(input), SoundCard.open(output));
    }

    private TargetDataLine input(AudioFormat format) throws LineUnavailableException {
        return (TargetDataLine) line(new DataLine.Info(TargetDataLine.class, format));
    }

    private SourceDataLine output(AudioFormat format) throws LineUnavailableException {
        return (SourceDataLine) line(new DataLine.Info(SourceDataLine.class, format));
    }

    private Line line(DataLine.Info info) throws LineUnavailableException {
        if (name.isEmpty()) {
            return AudioSystem.getLine(info);
        }
        List<Mixer.Info> devices = Arrays.stream(AudioSystem.getMixerInfo())
                .filter(device -> AudioSystem.getMixer(device).isLineSupported(info))
                .toList();
        for (Mixer.Info device : devices) {
            if (device.getName().toLowerCase(Locale.ROOT).contains(name.toLowerCase(Locale.ROOT))) {
                return AudioSystem.getMixer(device).getLine(info);
            }
        }
        throw new LineUnavailableException("expected a device of "
                + devices.stream().map(Mixer.Info::getName).toList() + ", found " + name);
    }

    @Override
    public String toString() {
        return name.isEmpty() ? "the sound card" : "the sound card " + name;
    }

    /** Reads frames as the device takes them, and queues those to be played. */
    private record Channel(TargetDataLine in, AudioOutput out) implements ByteChannel {
        @Override
        public int read(ByteBuffer buffer) {
            byte[] octets = new byte[PcmFrames.OCTETS];
            int count = in.read(octets, 0, octets.length);
            buffer.put(octets, 0, count);
            return count == 0 ? -1 : count;
        }

        @Override
        public int write(ByteBuffer buffer) {
            short[] samples = new short[buffer.remaining() / 2];
            buffer.order(ByteOrder.LITTLE_ENDIAN).asShortBuffer().get(samples);
            buffer.position(buffer.limit());
            out.play(samples);
            return 2 * samples.length;
        }

        @Override
        public boolean isOpen() {
            return in.isOpen();
        }

        @Override
        public void close() {
            in.close();
            out.close();
        }
    }
}
