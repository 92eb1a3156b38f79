package gamephys;

import com.sun.jna.Pointer;
import java.util.function.Consumer;

/** What Scene has beside the methods that its declarations give. */
public abstract sealed class SceneBase extends Owned permits Scene {
    SceneBase(Pointer pointer, Consumer<Pointer> destroy) {
        super(pointer, destroy);
    }

    /** The shape of a model in its own coordinates; an exception for a mesh, which new Mesh(scene, model) gives. */
    public Shape getShape(int model) {
        Scratch scratch = Scratch.get();
        Layout<? extends Shape> layout = Shapes.layoutOf(((Scene) this).getInfo(model).type());
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_get_shape(self, model, scratch.slot(0), layout.bytes());
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return layout.reader().read(scratch.memory, Scratch.at(0));
    }
}
