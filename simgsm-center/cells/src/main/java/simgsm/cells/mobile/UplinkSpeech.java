package simgsm.cells.mobile;

import simgsm.abis.RtpPacket;
import simgsm.air.ProtocolViolation;
import simgsm.speech.SpeechCodec;

/** Converts a terminal's speech, possibly A-law, to GSM 06.10, the only codec of a traffic channel. */
final class UplinkSpeech {
    private SpeechCodec decoder = SpeechCodec.Kind.A_LAW.open();
    private SpeechCodec encoder = SpeechCodec.Kind.GSM_FULL_RATE.open();

    /** Restarts for another call. */
    void restart() {
        decoder = SpeechCodec.Kind.A_LAW.open();
        encoder = SpeechCodec.Kind.GSM_FULL_RATE.open();
    }

    /** Returns the packet with GSM 06.10; the same octets if it is already that. */
    byte[] convert(byte[] rtp) throws ProtocolViolation {
        RtpPacket packet = RtpPacket.decode(rtp);
        if (packet.payloadType() == RtpPacket.GSM_FULL_RATE) {
            return rtp;
        }
        return new RtpPacket(
                        RtpPacket.GSM_FULL_RATE,
                        packet.sequence(),
                        packet.timestamp(),
                        packet.source(),
                        encoder.encode(decoder.decode(packet.payload())))
                .encode();
    }
}
