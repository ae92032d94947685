package simrobot.app;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.file.Path;
import simgsm.file.PrivateFiles;
import simgsm.modem.VoiceStore;
import simgsm.words.SpeakerTemplates;
import simgsm.words.SpokenWord;
import simgsm.words.TemplateFolder;

/** Templates of callers, in one folder a number; what cannot be read or written is logged. @param folder of all */
record CallerVoices(Path folder) implements VoiceStore {
    private static final Logger LOG = System.getLogger(CallerVoices.class.getName());

    @Override
    public SpeakerTemplates read(String caller) {
        try {
            return of(caller).read();
        } catch (IOException e) {
            LOG.log(Level.WARNING, "voice of " + caller + ": " + e.getMessage());
            return new SpeakerTemplates();
        }
    }

    @Override
    public void add(String caller, String word, int number, SpokenWord template) {
        try {
            // a voice tells who calls
            PrivateFiles.makeFolder(folder.resolve(caller));
            of(caller).add(word, number, template);
        } catch (IOException e) {
            LOG.log(Level.WARNING, "voice of " + caller + ": " + e.getMessage());
        }
    }

    private TemplateFolder of(String caller) {
        return new TemplateFolder(folder.resolve(caller));
    }
}
