import java.io.DataOutputStream;
import java.io.FileOutputStream;

/** Writes the order "forward N centimetres" as DTMF: java Forge.java CENTIMETRES FILE.wav */
public class Forge {
    static final int RATE = 8000;
    static final String KEYS = "123456789*0#";
    static final int[] LOW = {697, 770, 852, 941};
    static final int[] HIGH = {1209, 1336, 1477};

    public static void main(String[] args) throws Exception {
        String order = "**#**" + args[0] + "**";
        int each = RATE / 5; // 200 ms: half of it tone, half of it silence
        short[] samples = new short[each * order.length()];
        for (int k = 0; k < order.length(); k++) {
            int key = KEYS.indexOf(order.charAt(k));
            for (int i = 0; i < each / 2; i++) {
                double t = 2 * Math.PI * i / RATE;
                samples[k * each + i] =
                        (short) (5700 * (Math.sin(t * LOW[key / 3]) + Math.sin(t * HIGH[key % 3])));
            }
        }
        try (DataOutputStream out = new DataOutputStream(new FileOutputStream(args[1]))) {
            int octets = 2 * samples.length;
            out.writeBytes("RIFF");
            little(out, 36 + octets, 4);
            out.writeBytes("WAVEfmt ");
            little(out, 16, 4); // length of what follows
            little(out, 1, 2); // PCM
            little(out, 1, 2); // one channel
            little(out, RATE, 4);
            little(out, 2 * RATE, 4); // octets per second
            little(out, 2, 2); // octets per sample
            little(out, 16, 2); // bits per sample
            out.writeBytes("data");
            little(out, octets, 4);
            for (short sample : samples) {
                little(out, sample, 2);
            }
        }
    }

    static void little(DataOutputStream out, int value, int octets) throws Exception {
        for (int i = 0; i < octets; i++) {
            out.write(value >> 8 * i);
        }
    }
}
